#include "sim/harvester/work_plan.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "algo/types/angles.h"
#include "sim/harvester/vehicle.h"

namespace honka::sim {
namespace {

/// Collects the keys; checks that every default lies in its range.
class Keys : public SettingsVisitor {
 public:
  void field(const Field& f, double& v, Range r) override { add(f, v >= r.low && v <= r.high); }
  void field(const Field& f, std::int64_t& v, Range r) override {
    const auto value = static_cast<double>(v);
    add(f, value >= r.low && value <= r.high);
  }
  void field(const Field& f, bool&) override { add(f, true); }
  void field(const Field& f, std::string&, const Choices&) override { add(f, true); }
  void field(const Field& f, std::vector<double>&, Range) override { add(f, true); }
  void field(const Field& f, std::vector<std::int64_t>&, Range) override { add(f, true); }
  void group(std::string_view, const std::function<void()>& fields) override { fields(); }
  std::set<std::string> keys;

 private:
  void add(const Field& f, bool in_range) {
    CHECK(in_range);
    CHECK(keys.insert(std::string(f.key)).second);
    CHECK((!f.help.empty() && !f.source.empty()));
  }
};

}  // namespace

TEST_CASE("the work goes drive, swing, process, swing back, drive, with hops of 2 to 5 m") {
  VehicleSettings settings;
  settings.stems_per_stop = 3;
  const WorkPlan plan(100.0, settings, 8);
  double place = 0.0, angle = 0.0, time = 0.0;
  int drives = 0;
  std::map<int, int> processed;
  for (const Phase& p : plan.phases()) {
    CHECK(p.start_s == Approx(time));
    CHECK(p.from_m == Approx(place));
    CHECK(p.from_rad == Approx(angle).margin(1e-12));
    if (p.task == Task::kDrive) {
      ++drives;
      CHECK(angle == 0.0);
      CHECK(p.to_m - p.from_m >= 1.0);
      CHECK(p.to_m - p.from_m <= 6.0);
    } else {
      CHECK(p.to_m == p.from_m);
    }
    if (p.task == Task::kProcess) {
      ++processed[drives];
      CHECK(std::fabs(p.to_rad) >= deg_to_rad(30.0) - 1e-12);
      CHECK(std::fabs(p.to_rad) <= deg_to_rad(60.0) + 1e-12);
    }
    place = p.to_m;
    angle = p.to_rad;
    time += p.duration_s;
  }
  CHECK(place == Approx(100.0));
  CHECK(drives >= 20);
  for (const auto& [drive, stems] : processed) CHECK(stems == 3);
}

TEST_CASE("speeds, accelerations and swing rates keep their limits and reach them") {
  VehicleSettings settings;
  settings.drive_speed_m_s = 0.8;
  settings.acceleration_m_s2 = 0.4;
  const WorkPlan plan(30.0, settings, 2);
  constexpr double kStep_s = 1e-3;
  double fastest = 0.0, hardest = 0.0, swing = 0.0, last_speed = 0.0;
  for (double t = 0.0; t + kStep_s < plan.duration_s(); t += kStep_s) {
    const double speed = (plan.travelled_m(t + kStep_s) - plan.travelled_m(t)) / kStep_s;
    const double rate = (plan.swing_rad(t + kStep_s) - plan.swing_rad(t)) / kStep_s;
    REQUIRE(speed > -1e-9);
    if (std::fabs(rate) > 1e-9) REQUIRE(speed < 0.01);
    if (t > 0.0) hardest = std::max(hardest, std::fabs(speed - last_speed) / kStep_s);
    fastest = std::max(fastest, speed);
    swing = std::max(swing, std::fabs(rate));
    last_speed = speed;
  }
  CHECK(fastest == Approx(0.8).epsilon(1e-3));
  CHECK(hardest == Approx(0.4).epsilon(0.01));
  CHECK(rad_to_deg(swing) == Approx(15.0).epsilon(0.01));
}

TEST_CASE("a forwarder drives through at 1 m/s") {
  const WorkPlan plan(100.0, forwarder_settings(), 2);
  REQUIRE(plan.phases().size() == 1);
  CHECK(plan.duration_s() == Approx(100.0 + 0.5 * kPi / 0.5));
  CHECK(plan.travelled_m(-1.0) == 0.0);
  CHECK(plan.travelled_m(1e4) == Approx(100.0));
  CHECK(plan.travelled_m(51.0) - plan.travelled_m(50.0) == Approx(1.0));
  CHECK(plan.swing_rad(50.0) == 0.0);
}

TEST_CASE("every setting has one key, a source, and a default inside its range") {
  VehicleSettings settings;
  Keys keys;
  describe(keys, settings);
  CHECK(keys.keys.size() == 19);
  CHECK(keys.keys.count("sensor_height_m") == 1);
}

}  // namespace honka::sim
