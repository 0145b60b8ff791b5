#pragma once

#include <filesystem>
#include <string>

namespace honka::eval {

/// The text of a file, also of a gzipped one (by its first two bytes, whatever its name). UserError
/// when it is missing, a folder, unreadable, not whole, damaged, or beyond 4 GiB when unpacked.
[[nodiscard]] std::string read_text_or_gzip(const std::filesystem::path& path);

}  // namespace honka::eval
