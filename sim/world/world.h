#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace honka::sim {

/// What a ray can hit. The values are those of the recording's truth labels.
enum class Part : std::uint8_t {
  kNone = 0,
  kGround,
  kStem,
  kBranch,
  kDeadBranch,
  kFoliage,
  kUndergrowth,
  kRock,
  kStump,
  kLog,
  kMachine,
  kWall,
};
inline constexpr int kPartCount = 12;

[[nodiscard]] std::string_view part_name(Part part);

/// Truth of a surface: its part and the tree (Tree::id) it belongs to, −1 for none.
struct Label {
  std::int32_t owner = -1;
  Part part = Part::kNone;

  bool operator==(const Label&) const = default;
};

/// Truncated cone between two discs (no caps); world frame, metres.
struct Cone {
  Eigen::Vector3d a_m, b_m;
  double radius_a_m = 0.0, radius_b_m = 0.0;
  Label label;
};

/// Ellipsoid with principal half axes along x, y, z after a turn by yaw about z.
struct Ellipsoid {
  Eigen::Vector3d centre_m;
  Eigen::Vector3d half_axes_m;
  double yaw_rad = 0.0;
  Label label;
};

/// Triangles with counter-clockwise corners seen from outside.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices_m;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Label label;
};

/// All that a ray can hit and that stands still, with the diffuse reflectivity of each part.
struct World {
  std::vector<Cone> cones;
  std::vector<Ellipsoid> ellipsoids;
  std::vector<TriangleMesh> meshes;
  /// Diffuse reflectivity in percent by part, at 905 nm.
  std::array<double, kPartCount> reflectivity_percent = {0,  25, 40, 35, 30, 45,
                                                         45, 30, 45, 40, 50, 50};
};

}  // namespace honka::sim
