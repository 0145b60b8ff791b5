#pragma once

#include <embree3/rtcore.h>

#include <cstddef>
#include <span>
#include <vector>

#include "sim/lidar/build_statistics.h"
#include "sim/lidar/cone_pieces.h"
#include "sim/lidar/ray_ellipsoid.h"
#include "sim/world/world.h"

namespace honka::sim {

/// What a ray met.
struct Hit {
  double range_m = kNoHit;  ///< along the ray; kNoHit = nothing
  Label label;
  double incidence_cosine = 0.0;  ///< between the ray and the surface's normal, in [0, 1]
};

/// Everything that stands still, behind one Embree scene: cones and ellipsoids as user geometry
/// with exact intersections in double precision, meshes as triangles. Const calls are thread-safe.
class EmbreeScene {
 public:
  explicit EmbreeScene(const World& world);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// A query for the first surface along the ray nearer than `far_m`; the direction is a unit
  /// vector.
  static void aim(RTCRayHit& query, const Ray& ray, double far_m);
  /// Answers the queries one by one, in order.
  void cast(std::span<RTCRayHit> queries) const;
  /// What an answered query met.
  [[nodiscard]] Hit hit_of(const RTCRayHit& query) const;
  [[nodiscard]] const BuildStatistics& statistics() const { return statistics_; }
  /// For benchmarks: the bare scene.
  [[nodiscard]] RTCScene handle() const { return scene_; }

 private:
  void attach_cones(const World& world);
  void attach_ellipsoids(const World& world);
  void attach_mesh(const TriangleMesh& mesh);
  void attach_user_geometry(std::size_t count, void* data, RTCBoundsFunction bounds,
                            RTCIntersectFunctionN intersect);

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<PackedCone> cones_;
  std::vector<Label> cone_labels_;
  std::vector<PackedEllipsoid> ellipsoids_;
  std::vector<Label> ellipsoid_labels_;
  std::vector<Label> mesh_labels_;
  std::size_t embree_bytes_ = 0;
  BuildStatistics statistics_;
};

inline void EmbreeScene::aim(RTCRayHit& query, const Ray& ray, double far_m) {
  query.ray.org_x = static_cast<float>(ray.ox);
  query.ray.org_y = static_cast<float>(ray.oy);
  query.ray.org_z = static_cast<float>(ray.oz);
  query.ray.dir_x = static_cast<float>(ray.dx);
  query.ray.dir_y = static_cast<float>(ray.dy);
  query.ray.dir_z = static_cast<float>(ray.dz);
  query.ray.tnear = 0.0F;
  query.ray.tfar = static_cast<float>(far_m);
  query.ray.time = 0.0F;
  query.ray.mask = ~0U;
  query.ray.flags = 0;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
}

}  // namespace honka::sim
