#include "eval/cli/index_file.h"

#include <span>
#include <string>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"

namespace honka::eval {
namespace {

ConsensusIndex read_index_file(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  const auto* first = reinterpret_cast<const std::uint8_t*>(text.data());
  try {
    return ConsensusIndex::from_bytes(std::span(first, text.size()));
  } catch (const UserError& error) {
    throw UserError("--index " + file.string() + ": " + error.what() +
                    "; name another file, or delete this one and it is written anew");
  }
}

}  // namespace

IndexFromFile load_or_build_index(const std::filesystem::path& file,
                                  const std::vector<Eigen::Vector2d>& stems_in_map_m) {
  IndexFromFile result;
  if (std::filesystem::exists(file)) {
    auto index = std::make_shared<const ConsensusIndex>(read_index_file(file));
    result.loaded = index->hash() == map_hash(stems_in_map_m);
    result.foreign = !result.loaded;
    if (result.loaded) result.index = std::move(index);
  }
  if (!result.index) result.index = std::make_shared<const ConsensusIndex>(stems_in_map_m);
  return result;
}

void write_index_file(const std::filesystem::path& file, const ConsensusIndex& index) {
  const std::vector<std::uint8_t> bytes = index.to_bytes();
  write_file_safely(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace honka::eval
