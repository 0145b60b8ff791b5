#include "sim/lidar/embree_scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <string>

#include "algo/types/check.h"
#include "algo/types/user_error.h"

namespace honka::sim {
namespace {

// Geometry ids, in the order of attachment.
constexpr unsigned kConeGeometry = 0;
constexpr unsigned kEllipsoidGeometry = 1;
constexpr unsigned kFirstMesh = 2;

/// Largest side across which a piece of a cone may reach; measured: smaller costs memory, larger
/// time.
constexpr double kWidestPiece_m = 0.3;

bool count_bytes(void* total, ssize_t bytes, bool) {
  *static_cast<std::size_t*>(total) += static_cast<std::size_t>(bytes);
  return true;
}

/// Tests one primitive against the ray of an rtcIntersect1.
template <typename Primitive>
void intersect_user(const RTCIntersectFunctionNArguments* args) {
  // N is 1: this scene is never asked for packets.
  if (args->valid[0] == 0) return;
  const Primitive& primitive = static_cast<const Primitive*>(args->geometryUserPtr)[args->primID];
  auto& query = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  RTCRay& r = query.ray;
  const Ray ray = {r.org_x, r.org_y, r.org_z, r.dir_x, r.dir_y, r.dir_z};
  const double t = intersect(ray, primitive, r.tnear, r.tfar);
  if (t == kNoHit) return;
  r.tfar = static_cast<float>(t);
  query.hit.geomID = args->geomID;
  query.hit.primID = args->primID;
}

void set_bounds(const Box& box, RTCBounds* out) {
  out->lower_x = box.low.x(), out->lower_y = box.low.y(), out->lower_z = box.low.z();
  out->upper_x = box.high.x(), out->upper_y = box.high.y(), out->upper_z = box.high.z();
}

void cone_bounds(const RTCBoundsFunctionArguments* args) {
  set_bounds(bounds(static_cast<const PackedCone*>(args->geometryUserPtr)[args->primID]),
             args->bounds_o);
}

void ellipsoid_bounds(const RTCBoundsFunctionArguments* args) {
  const auto& e = static_cast<const PackedEllipsoid*>(args->geometryUserPtr)[args->primID];
  const Eigen::Vector3f centre(e.cx, e.cy, e.cz);
  const Eigen::Vector3f half(std::hypot(e.hx * e.yaw_cos, e.hy * e.yaw_sin),
                             std::hypot(e.hx * e.yaw_sin, e.hy * e.yaw_cos), e.hz);
  const Eigen::Vector3f reach = half * 1.00001F + Eigen::Vector3f::Constant(1e-4F);
  set_bounds({centre - reach, centre + reach}, args->bounds_o);
}

}  // namespace

EmbreeScene::EmbreeScene(const World& world) {
  const auto begin = std::chrono::steady_clock::now();
  // One instruction set, so that triangles have the same digits on every machine.
  device_ = rtcNewDevice("isa=avx2");
  if (device_ == nullptr) throw RunError("lidar: Embree needs a processor with AVX2");
  rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &embree_bytes_);
  scene_ = rtcNewScene(device_);
  attach_cones(world);
  attach_ellipsoids(world);
  for (const TriangleMesh& mesh : world.meshes) attach_mesh(mesh);
  rtcCommitScene(scene_);
  HONKA_CHECK(rtcGetDeviceError(device_) == RTC_ERROR_NONE, "Embree refused the scene");
  statistics_.primitives = cones_.size() + ellipsoids_.size();
  for (const TriangleMesh& mesh : world.meshes) statistics_.primitives += mesh.triangles.size();
  statistics_.bytes = embree_bytes_ + cones_.size() * (sizeof(PackedCone) + sizeof(Label)) +
                      ellipsoids_.size() * (sizeof(PackedEllipsoid) + sizeof(Label));
  statistics_.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcSetDeviceMemoryMonitorFunction(device_, nullptr, nullptr);
  rtcReleaseDevice(device_);
}

void EmbreeScene::attach_user_geometry(std::size_t count, void* data, RTCBoundsFunction bounds,
                                       RTCIntersectFunctionN intersect) {
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(count));
  rtcSetGeometryUserData(geometry, data);
  rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::attach_cones(const World& world) {
  ConePieces pieces = cut_into_pieces(world.cones, kWidestPiece_m);
  cones_ = std::move(pieces.cones);
  cone_labels_ = std::move(pieces.labels);
  attach_user_geometry(cones_.size(), cones_.data(), cone_bounds, intersect_user<PackedCone>);
}

void EmbreeScene::attach_ellipsoids(const World& world) {
  for (const Ellipsoid& e : world.ellipsoids) {
    ellipsoids_.push_back(packed(e));
    ellipsoid_labels_.push_back(e.label);
  }
  attach_user_geometry(ellipsoids_.size(), ellipsoids_.data(), ellipsoid_bounds,
                       intersect_user<PackedEllipsoid>);
}

void EmbreeScene::attach_mesh(const TriangleMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Eigen::Vector3f), mesh.vertices_m.size());
  void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(mesh.triangles[0]), mesh.triangles.size());
  HONKA_CHECK(vertices != nullptr && triangles != nullptr, "no memory for a mesh");
  std::memcpy(vertices, mesh.vertices_m.data(), mesh.vertices_m.size() * sizeof(Eigen::Vector3f));
  std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  mesh_labels_.push_back(mesh.label);
}

void EmbreeScene::cast(std::span<RTCRayHit> queries) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (RTCRayHit& query : queries) {
    rtcIntersect1(scene_, &context, &query);
    // The label is read when the whole batch has been cast; it is on its way until then.
    if (query.hit.geomID == kConeGeometry) __builtin_prefetch(&cone_labels_[query.hit.primID]);
  }
}

Hit EmbreeScene::hit_of(const RTCRayHit& query) const {
  const unsigned geometry = query.hit.geomID;
  if (geometry == RTC_INVALID_GEOMETRY_ID) return {};
  const unsigned primitive = query.hit.primID;
  const double range = query.ray.tfar;
  const RTCRay& r = query.ray;
  const Ray ray = {r.org_x, r.org_y, r.org_z, r.dir_x, r.dir_y, r.dir_z};
  if (geometry == kConeGeometry) {
    return {range, cone_labels_[primitive], incidence_cosine(ray, cones_[primitive], range)};
  }
  if (geometry == kEllipsoidGeometry) {
    return {range, ellipsoid_labels_[primitive],
            incidence_cosine(ray, ellipsoids_[primitive], range)};
  }
  const Eigen::Vector3d normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
  const double cosine =
      std::fabs(normal.dot(Eigen::Vector3d(ray.dx, ray.dy, ray.dz))) / normal.norm();
  return {range, mesh_labels_[geometry - kFirstMesh], std::min(1.0, cosine)};
}

}  // namespace honka::sim
