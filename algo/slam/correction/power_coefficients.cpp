#include "algo/slam/correction/power_coefficients.h"

#include <algorithm>
#include <cmath>

#include "algo/geometry/se3.h"
#include "algo/geometry/se3_power.h"
#include "algo/types/check.h"

namespace honka {
namespace {

/// d(τ)² of Eq. 31.
double squared_motion(const Pose3& motion, const MotionMetric& metric) {
  return metric.a_m2 * so3_log(motion.linear()).squaredNorm() +
         metric.b * motion.translation().squaredNorm();
}

/// Nevalainen2021 Eq. (21)
std::vector<double> index_shares(std::size_t gap) {
  std::vector<double> shares(gap + 1);
  for (std::size_t l = 0; l <= gap; ++l) {
    shares[l] = static_cast<double>(l) / static_cast<double>(gap);
  }
  return shares;
}

/// Running sums of what each step adds, over the whole sum.
template <typename Step>
std::vector<double> cumulative_shares(std::size_t gap, const Step& step) {
  std::vector<double> shares(gap + 1, 0.0);
  for (std::size_t l = 1; l <= gap; ++l) shares[l] = shares[l - 1] + step(l);
  const double whole = shares[gap];
  if (!(whole > 0.0)) return index_shares(gap);
  for (double& share : shares) share /= whole;
  return shares;
}

/// Nevalainen2021 Eq. (31)
std::vector<double> metric_shares(const std::vector<Pose3>& T_j_l, const MotionMetric& metric) {
  const double whole = squared_motion(T_j_l.back(), metric);
  if (!(whole > 0.0)) return index_shares(T_j_l.size() - 1);
  std::vector<double> shares;
  for (const Pose3& motion : T_j_l) {
    shares.push_back(std::min(1.0, std::sqrt(squared_motion(motion, metric) / whole)));
  }
  return shares;
}

/// The least of a function with one valley in [low, high], by golden sections.
template <typename Function>
double least_between(double low, double high, const Function& f) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double f_left = f(left), f_right = f(right);
  while (high - low > 1e-9) {
    const bool go_left = f_left < f_right;
    (go_left ? high : low) = go_left ? right : left;
    (go_left ? right : left) = go_left ? left : right;
    (go_left ? f_right : f_left) = go_left ? f_left : f_right;
    double& fresh = go_left ? left : right;
    fresh = go_left ? high - golden * (high - low) : low + golden * (high - low);
    (go_left ? f_left : f_right) = f(fresh);
  }
  return 0.5 * (low + high);
}

/// Nevalainen2021 Eq. (32), with the path τ_u from the identity at j to T_j_i: that of the printed
/// τ_j1^(1−u) τ_i1^u does not lie in frame j, where τ_lj does.
std::vector<double> nearest_shares(const std::vector<Pose3>& T_j_l, const MotionMetric& metric) {
  const PosePower path(T_j_l.back());
  const auto steps = std::max<std::int64_t>(1, metric.nearest_steps);
  std::vector<Pose3> T_u_j;  // τ_u⁻¹ at the tried u
  for (std::int64_t k = 0; k <= steps; ++k) {
    T_u_j.push_back(path(-static_cast<double>(k) / static_cast<double>(steps)));
  }
  std::vector<double> shares;
  for (const Pose3& motion : T_j_l) {
    std::vector<double> tried;
    for (const Pose3& pose : T_u_j) tried.push_back(squared_motion(pose * motion, metric));
    const auto least = std::min_element(tried.begin(), tried.end()) - tried.begin();
    const double step = 1.0 / static_cast<double>(steps), u = static_cast<double>(least) * step;
    shares.push_back(
        metric.nearest_refined
            ? least_between(std::max(0.0, u - step), std::min(1.0, u + step),
                            [&](double s) { return squared_motion(path(-s) * motion, metric); })
            : u);
  }
  return shares;
}

}  // namespace

void describe(SettingsVisitor& v, MotionMetric& s) {
  v.field({"a_m2", "m2", "weight of a squared turn (rad²) in the metric d(τ)²",
           "choice: Nevalainen2021 §4.1 leaves it free"},
          s.a_m2, Range{0.0, 1e6});
  v.field({"b", "", "weight of a squared translation (m²) in it",
           "choice: Nevalainen2021 §4.1 leaves it free"},
          s.b, Range{0.0, 1e6});
  v.field({"nearest_steps", "", "parts of [0, 1] at whose ends Eq. 32 is tried", "choice"},
          s.nearest_steps, Range{1.0, 1e5});
  v.field({"nearest_refined", "", "look for the least between the neighbours too", "choice"},
          s.nearest_refined);
}

const std::vector<std::string>& power_coefficient_names() {
  static const std::vector<std::string> kNames = {"index", "path", "errors", "metric", "nearest"};
  return kNames;
}

PowerCoefficient power_coefficient(const std::string& name) {
  const auto& names = power_coefficient_names();
  const auto found = std::find(names.begin(), names.end(), name);
  HONKA_CHECK(found != names.end(), "the name of a coefficient");
  return static_cast<PowerCoefficient>(found - names.begin());
}

std::vector<double> power_coefficients(const FramePoses& T_first_frame, std::size_t j,
                                       std::size_t i, PowerCoefficient kind,
                                       std::span<const double> step_errors_m,
                                       const MotionMetric& metric) {
  HONKA_CHECK(j < i && i < T_first_frame.size(), "two frames of the map, j before i");
  const std::size_t gap = i - j;
  std::vector<Pose3> T_j_l;
  if (kind == PowerCoefficient::kMetric || kind == PowerCoefficient::kNearest) {
    const Pose3 T_j_first = T_first_frame[j].inverse();
    for (std::size_t l = j; l <= i; ++l) T_j_l.push_back(T_j_first * T_first_frame[l]);
  }
  std::vector<double> shares;
  switch (kind) {
    case PowerCoefficient::kIndex:
      shares = index_shares(gap);
      break;
    case PowerCoefficient::kPath:
      shares = cumulative_shares(gap, [&](std::size_t l) {
        return (T_first_frame[j + l].translation() - T_first_frame[j + l - 1].translation()).norm();
      });
      break;
    case PowerCoefficient::kErrors:
      HONKA_CHECK(i <= step_errors_m.size(), "an error of each step");
      shares = cumulative_shares(gap, [&](std::size_t l) { return step_errors_m[j + l - 1]; });
      break;
    case PowerCoefficient::kMetric:
      shares = metric_shares(T_j_l, metric);
      break;
    case PowerCoefficient::kNearest:
      shares = nearest_shares(T_j_l, metric);
      break;
  }
  shares.front() = 0.0;
  shares.back() = 1.0;
  return shares;
}

}  // namespace honka
