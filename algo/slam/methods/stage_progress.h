#pragma once

#include <cstddef>
#include <functional>

namespace honka {

/// Told now and then how much of a stage is done; may be empty.
using StageProgress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace honka
