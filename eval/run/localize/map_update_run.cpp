#include "eval/run/localize/map_update_run.h"

#include <algorithm>
#include <memory>

#include "algo/types/user_error.h"
#include "eval/metrics/localization.h"
#include "eval/run/localize/timed_matcher.h"
#include "eval/run/stopwatch.h"

namespace honka::eval {
namespace {

using Stems2d = std::vector<Eigen::Vector2d>;

/// A map and a matcher of every method over it; none where the map cannot be matched in.
struct AskedMap {
  std::string name, fed_by;
  std::int64_t stems = 0;
  std::vector<std::unique_ptr<Matcher>> matchers;

  void make_matchers(const Stems2d& map_m, const std::vector<std::string>& methods,
                     const LocalizeSettings& settings) {
    stems = static_cast<std::int64_t>(map_m.size());
    matchers.clear();
    for (const std::string& method : methods) {
      matchers.emplace_back();
      try {
        matchers.back() = create_matcher(method, map_m, settings);
      } catch (const UserError&) {
        // Too few stems are left: every answer is a refusal.
      }
    }
  }
};

/// What updates one of the asked maps.
struct FedMap {
  std::size_t asked = 0, method = 0;
  MapUpdater updater;
  MapUpdate update;
  std::int64_t accepted = 0, counted = 0, updates = 0;
  double update_ms = 0.0;
};

class UpdatingDrive {
 public:
  UpdatingDrive(const Scenario& scenario, const MapUpdateWorld& world, int threads)
      : scenario_(scenario),
        world_(world),
        threads_(threads),
        methods_(methods_of(scenario.variants.methods, scenario.localize)) {
    add_map("old", "", world.old_map_m);
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      fed_.push_back(
          {maps_.size(), m, MapUpdater(world.old_map_m, scenario.map_update.updater), {}});
      fed_.back().update = fed_.back().updater.update();
      add_map("updated", methods_[m], world.old_map_m);
    }
    add_map("new", "", world.new_map_m);
  }

  MapUpdateRun run(const std::function<void(std::int64_t)>& advance) {
    take_snapshots(0, 0);
    const std::size_t lists = world_.T_world_sensor.size();
    for (std::size_t at = 0; at < lists;) {
      const std::int64_t part = part_of(at);
      std::size_t end =
          std::min(lists, at + static_cast<std::size_t>(scenario_.map_update.update_every));
      while (part_of(end - 1) != part) --end;
      ask(at, end);
      update_maps(at, end);
      if (end == lists || part_of(end) != part) take_snapshots(part, end);
      advance(static_cast<std::int64_t>(end - at));
      at = end;
    }
    return std::move(run_);
  }

 private:
  void add_map(const std::string& name, const std::string& fed_by, const Stems2d& map_m) {
    AskedMap map{name, fed_by, 0, {}};
    map.make_matchers(map_m, methods_, scenario_.localize);
    maps_.push_back(std::move(map));
  }

  [[nodiscard]] std::int64_t part_of(std::size_t list) const {
    return 1 + kDriveParts * static_cast<std::int64_t>(list) /
                   static_cast<std::int64_t>(world_.T_world_sensor.size());
  }

  [[nodiscard]] std::size_t asked_a_list() const { return maps_.size() * methods_.size(); }

  /// The lists [at, end), every one in every map by every method.
  void ask(std::size_t at, std::size_t end) {
    lists_.assign(end - at, {});
    const std::size_t first = run_.answers.size(), each = asked_a_list();
    run_.answers.resize(first + lists_.size() * each);
#pragma omp parallel for schedule(dynamic) num_threads(threads_)
    for (std::size_t i = 0; i < lists_.size(); ++i) {
      lists_[i] = list_at(world_, scenario_, at + i);
      for (std::size_t c = 0; c < each; ++c) {
        run_.answers[first + i * each + c] =
            answer(at + i, lists_[i], maps_[c / methods_.size()], c % methods_.size());
      }
    }
  }

  [[nodiscard]] MapUpdateAnswer answer(std::size_t list, const Stems2d& stems_m,
                                       const AskedMap& map, std::size_t method) const {
    MapUpdateAnswer row;
    row.list = static_cast<std::int64_t>(list);
    row.part = part_of(list);
    row.map = map.name;
    row.fed_by = map.fed_by;
    row.method = methods_[method];
    row.stems = static_cast<std::int64_t>(stems_m.size());
    row.stems_in_map = map.stems;
    if (!map.matchers[method]) return row;
    const Stopwatch watch;
    const LocateResult result = map.matchers[method]->locate(stems_m);
    row.match_ms = watch.milliseconds();
    row.verdict = result.verdict;
    row.T_map_local = result.T_map_local;
    const PoseError error = pose_error(result.T_map_local, world_.T_world_sensor[list]);
    row.translation_error_m = error.translation_m;
    row.rotation_error_rad = error.rotation_rad;
    const ProtocolSettings& p = scenario_.protocol;
    row.success = judge(result.accepted(), error, {p.success_translation_m, p.success_rotation_deg})
                      .success();
    return row;
  }

  /// Each updater hears the accepted answers of its own method in its own map.
  void update_maps(std::size_t at, std::size_t end) {
    const std::size_t each = asked_a_list();
    for (FedMap& fed : fed_) {
      const Stopwatch watch;
      for (std::size_t list = at; list < end; ++list) {
        const MapUpdateAnswer& own =
            run_.answers[list * each + fed.asked * methods_.size() + fed.method];
        if (!own.accepted()) continue;
        ++fed.accepted;
        fed.counted += fed.updater.add_view(own.T_map_local, lists_[list - at]) ? 1 : 0;
      }
      fed.update = fed.updater.update();
      maps_[fed.asked].make_matchers(fed.update.stems_in_map_m, methods_, scenario_.localize);
      fed.update_ms += watch.milliseconds();
      ++fed.updates;
    }
  }

  void take_snapshots(std::int64_t part, std::size_t lists) {
    for (const FedMap& fed : fed_) {
      const double mean_ms =
          fed.updates == 0 ? 0.0 : fed.update_ms / static_cast<double>(fed.updates);
      run_.snapshots.push_back(
          {methods_[fed.method], part, lists, fed.accepted, fed.counted, fed.update, mean_ms});
    }
  }

  const Scenario& scenario_;
  const MapUpdateWorld& world_;
  int threads_;
  std::vector<std::string> methods_;
  std::vector<AskedMap> maps_;
  std::vector<FedMap> fed_;
  std::vector<Stems2d> lists_;  ///< of the batch that was asked last
  MapUpdateRun run_;
};

}  // namespace

MapUpdateRun run_map_update(const Scenario& scenario, const MapUpdateWorld& world, int threads,
                            const std::function<void(std::int64_t)>& advance) {
  return UpdatingDrive(scenario, world, threads).run(advance);
}

}  // namespace honka::eval
