#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "algo/localize/consensus/index.h"

namespace honka::eval {

/// What became of an index file.
struct IndexFromFile {
  std::shared_ptr<const ConsensusIndex> index;
  bool loaded = false;   ///< else it was built
  bool foreign = false;  ///< the file holds the index of another map
};

/// The index of a map: from the file where it holds that map's, else built. UserError for a file
/// that is no index or a damaged one, and for a map that cannot be indexed.
[[nodiscard]] IndexFromFile load_or_build_index(const std::filesystem::path& file,
                                                const std::vector<Eigen::Vector2d>& stems_in_map_m);

/// Writes it under a temporary name, then renames. UserError when it cannot be written.
void write_index_file(const std::filesystem::path& file, const ConsensusIndex& index);

}  // namespace honka::eval
