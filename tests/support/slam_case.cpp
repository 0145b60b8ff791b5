#include "tests/support/slam_case.h"

#include <zlib.h>

#include <array>
#include <cctype>
#include <cstdlib>
#include <stdexcept>

namespace honka::test {

std::optional<std::filesystem::path> shared_slam_cases() {
  const auto folder =
      std::filesystem::path(HONKA_SOURCE_DIR).parent_path() / "shared" / "data" / "slam_cases";
  if (!std::filesystem::exists(folder)) return std::nullopt;
  return folder;
}

std::vector<std::vector<double>> read_number_rows(const std::filesystem::path& file) {
  gzFile stream = gzopen(file.c_str(), "rb");
  if (stream == nullptr) throw std::runtime_error(file.string() + ": cannot be opened");
  std::vector<std::vector<double>> rows;
  std::array<char, 4096> line{};
  while (gzgets(stream, line.data(), line.size()) != nullptr) {
    if (line[0] == '#' || std::isalpha(static_cast<unsigned char>(line[0])) != 0) continue;
    std::vector<double> row;
    char* at = line.data();
    for (char* end = at;; at = end + 1) {
      const double value = std::strtod(at, &end);
      if (end == at) break;
      row.push_back(value);
      if (*end != ',') break;
    }
    if (!row.empty()) rows.push_back(std::move(row));
  }
  gzclose(stream);
  return rows;
}

std::vector<std::vector<Eigen::Vector3d>> read_frame_points(const std::filesystem::path& file) {
  std::vector<std::vector<Eigen::Vector3d>> frames;
  for (const auto& row : read_number_rows(file)) {
    const auto frame = static_cast<std::size_t>(row.at(0));
    if (frame >= frames.size()) frames.resize(frame + 1);
    frames[frame].emplace_back(row.at(1), row.at(2), row.at(3));
  }
  return frames;
}

std::vector<Pose3> read_pose_rows(const std::filesystem::path& file, std::size_t first) {
  std::vector<Pose3> poses;
  for (const auto& row : read_number_rows(file)) {
    Pose3 pose = Pose3::Identity();
    for (std::size_t k = 0; k < 12; ++k) {
      pose.matrix()(static_cast<Eigen::Index>(k / 4), static_cast<Eigen::Index>(k % 4)) =
          row.at(first + k);
    }
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace honka::test
