#include "algo/slam/fleet.h"

#include <algorithm>
#include <cmath>

#include "algo/slam/slam_stages.h"
#include "algo/types/angles.h"

namespace honka {
namespace {

/// All frames of all vehicles in one list, with where each vehicle's begin.
struct FleetFrames {
  std::vector<SparseFrame> frames;
  FramePoses poses;  ///< in each vehicle's own first frame, then in the map
  std::vector<std::size_t> starts;
  [[nodiscard]] std::size_t end(std::size_t vehicle) const {
    return vehicle + 1 < starts.size() ? starts[vehicle + 1] : frames.size();
  }
  [[nodiscard]] std::vector<std::size_t> lookouts(std::size_t vehicle, std::int64_t step) const {
    std::vector<std::size_t> result;
    for (std::size_t l = starts[vehicle]; l < end(vehicle); l += static_cast<std::size_t>(step)) {
      result.push_back(l);
    }
    return result;
  }
};

/// Where the map of one vehicle lies in that of another, and the matches that agree on it.
struct FleetJoin {
  std::size_t target = 0, source = 0;  ///< vehicles
  Pose3 T_target_source = Pose3::Identity();
  std::vector<PairMatch> matches;
};

FleetFrames map_alone(std::span<const VehicleDrive> vehicles, const SlamSettings& settings,
                      FleetResult& result) {
  FleetFrames fleet;
  result.vehicles.resize(vehicles.size());
  for (std::size_t k = 0; k < vehicles.size(); ++k) {
    fleet.starts.push_back(fleet.frames.size());
    if (vehicles[k].frames.empty()) continue;
    SlamResult alone = run_slam(vehicles[k].frames, vehicles[k].T_first_frame_chain, settings);
    std::vector<FrameStatus> ignored;
    for (SparseFrame& frame : clean_frames(vehicles[k].frames, ignored)) {
      fleet.frames.push_back(std::move(frame));
    }
    fleet.poses.insert(fleet.poses.end(), alone.T_first_frame.begin(), alone.T_first_frame.end());
    result.vehicles[k].frames = std::move(alone.frames);
  }
  return fleet;
}

bool agree(const Pose3& a, const Pose3& b, const FleetSettings& settings) {
  const Pose3 off = a.inverse() * b;
  return off.translation().norm() <= settings.agreement_m &&
         std::abs(yaw_of(off)) <= deg_to_rad(settings.agreement_deg);
}

/// The largest set of matches that agree with one of them.
FleetJoin join_of(const FleetFrames& fleet, std::size_t target, std::size_t source,
                  const SlamSettings& settings, const FleetSettings& s) {
  const VerifiedPairs found = propose_pairs(fleet.frames, fleet.lookouts(target, s.lookout_step),
                                            fleet.lookouts(source, s.lookout_step), settings.view,
                                            settings.match, settings.pairs);
  std::vector<Pose3> said;  // T_target_source by each match
  for (const PairMatch& match : found.matches) {
    said.push_back(fleet.poses[match.earlier] * match.T_earlier_later *
                   fleet.poses[match.later].inverse());
  }
  FleetJoin best{target, source, Pose3::Identity(), {}};
  for (const Pose3& candidate : said) {
    std::vector<PairMatch> agreeing;
    for (std::size_t k = 0; k < said.size(); ++k) {
      if (agree(candidate, said[k], s)) agreeing.push_back(found.matches[k]);
    }
    if (agreeing.size() <= best.matches.size()) continue;
    best.T_target_source = candidate;
    best.matches = std::move(agreeing);
  }
  return best;
}

/// Joins between all vehicles that enough matches agree on.
std::vector<FleetJoin> find_joins(const FleetFrames& fleet, const SlamSettings& settings,
                                  const FleetSettings& s) {
  std::vector<FleetJoin> joins;
  for (std::size_t a = 0; a < fleet.starts.size(); ++a) {
    for (std::size_t b = a + 1; b < fleet.starts.size(); ++b) {
      FleetJoin join = join_of(fleet, a, b, settings, s);
      if (static_cast<std::int64_t>(join.matches.size()) >= s.min_joins) {
        joins.push_back(std::move(join));
      }
    }
  }
  return joins;
}

/// Lays the vehicles that joins lead to into the map of the first one that has frames.
void place_joined(FleetFrames& fleet, const std::vector<FleetJoin>& joins, FleetResult& result) {
  std::size_t first = 0;
  while (first < fleet.starts.size() && fleet.starts[first] == fleet.end(first)) ++first;
  if (first == fleet.starts.size()) return;
  std::vector<Pose3> T_map_first(fleet.starts.size(), Pose3::Identity());
  result.vehicles[first].joined = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (const FleetJoin& join : joins) {
      const bool forward = result.vehicles[join.target].joined;
      if (forward == result.vehicles[join.source].joined) continue;
      const std::size_t placed = forward ? join.target : join.source;
      const std::size_t next = forward ? join.source : join.target;
      T_map_first[next] =
          T_map_first[placed] * (forward ? join.T_target_source : join.T_target_source.inverse());
      result.vehicles[next].joined = grown = true;
    }
  }
  for (std::size_t k = 0; k < fleet.starts.size(); ++k) {
    for (std::size_t l = fleet.starts[k]; l < fleet.end(k); ++l) {
      fleet.poses[l] = T_map_first[k] * fleet.poses[l];
    }
  }
}

/// The joined vehicles' frames alone, as one list.
FleetFrames joined_alone(const FleetFrames& fleet, const FleetResult& result,
                         std::vector<std::size_t>& position) {
  FleetFrames joined;
  position.assign(fleet.frames.size(), fleet.frames.size());
  for (std::size_t k = 0; k < fleet.starts.size(); ++k) {
    if (!result.vehicles[k].joined) continue;
    joined.starts.push_back(joined.frames.size());
    for (std::size_t l = fleet.starts[k]; l < fleet.end(k); ++l) {
      position[l] = joined.frames.size();
      joined.frames.push_back(fleet.frames[l]);
      joined.poses.push_back(fleet.poses[l]);
    }
  }
  return joined;
}

std::vector<PoseGraphEdge> fleet_edges(const FleetFrames& joined,
                                       const std::vector<FleetJoin>& joins,
                                       const std::vector<std::size_t>& position,
                                       const PoseGraphSettings& settings) {
  auto edges = chain_edges(joined.poses, {}, settings);
  std::erase_if(edges, [&](const PoseGraphEdge& edge) {
    return std::binary_search(joined.starts.begin(), joined.starts.end(), edge.source);
  });
  for (const FleetJoin& join : joins) {
    std::vector<PairMatch> matches = join.matches;
    for (PairMatch& match : matches) {
      match.earlier = position[match.earlier];
      match.later = position[match.later];
    }
    const auto more = match_edges(matches, settings);
    edges.insert(edges.end(), more.begin(), more.end());
  }
  return edges;
}

}  // namespace

void describe(SettingsVisitor& v, FleetSettings& s) {
  v.field({"lookout_step", "", "frames between those that look for another vehicle", "choice"},
          s.lookout_step, Range{1.0, 1e6});
  v.field({"min_joins", "", "matches that must agree on where one map lies in the other",
           "choice: one may be chance"},
          s.min_joins, Range{1.0, 1e6});
  v.field({"agreement_m", "m", "by which agreeing matches may differ", "choice"}, s.agreement_m,
          Range{0.0, 100.0});
  v.field({"agreement_deg", "deg", "and by which angle", "choice"}, s.agreement_deg,
          Range{0.0, 180.0});
}

FleetResult run_fleet(std::span<const VehicleDrive> vehicles, const SlamSettings& settings,
                      const FleetSettings& fleet_settings) {
  FleetResult result;
  FleetFrames fleet = map_alone(vehicles, settings, result);
  const std::vector<FleetJoin> joins = find_joins(fleet, settings, fleet_settings);
  place_joined(fleet, joins, result);

  std::vector<std::size_t> position;
  FleetFrames joined = joined_alone(fleet, result, position);
  const auto edges = fleet_edges(joined, joins, position, settings.pose_graph);
  joined.poses = optimize_pose_graph(joined.poses, edges, settings.pose_graph).T_first_frame;
  if (settings.method == "landmark_ba") {
    joined.poses = adjust_landmarks(joined.frames, joined.poses, settings.stem_map,
                                    settings.landmark_ba, joined.starts)
                       .T_first_frame;
  }
  result.stems = build_stem_map(joined.frames, joined.poses, settings.stem_map).stems;

  for (std::size_t k = 0; k < vehicles.size(); ++k) {
    for (std::size_t l = fleet.starts[k]; l < fleet.end(k); ++l) {
      const bool in_map = position[l] < joined.poses.size();
      result.vehicles[k].T_map_frame.push_back(in_map ? joined.poses[position[l]] : fleet.poses[l]);
    }
    for (const FleetJoin& join : joins) {
      if (join.target == k || join.source == k) result.vehicles[k].joins += join.matches.size();
    }
  }
  return result;
}

}  // namespace honka
