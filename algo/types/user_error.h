#pragma once

#include <stdexcept>
#include <string>

namespace honka {

/// A mistake in the user's input: one line that says where and how to mend it; exit code 2.
///
/// The message reads "file:line:column: what is wrong; what to do", as far as these are known.
class UserError : public std::runtime_error {
 public:
  explicit UserError(const std::string& line) : std::runtime_error(line) {}
};

/// A run that could not finish through no fault of its input (disk full, interrupted); exit code 3.
class RunError : public std::runtime_error {
 public:
  explicit RunError(const std::string& line) : std::runtime_error(line) {}
};

}  // namespace honka
