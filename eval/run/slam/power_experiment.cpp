#include "eval/run/slam/power_experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algo/geometry/se3_power.h"
#include "algo/types/random.h"
#include "eval/run/slam/figure_results.h"
#include "eval/run/slam/power_figures.h"

namespace honka::eval {
namespace {

constexpr std::uint64_t kTransforms = 300;  // as in the paper
constexpr int kPowers = 100;                // powers k/100, and products of 1 … 100 factors
constexpr double kPaperProductError = 4.8e-3;

/// p uniform in [−1, 1]³, the axis uniform over the sphere, the angle uniform in [0, π].
Pose3 random_transform(std::uint64_t seed, std::uint64_t id) {
  RandomStream random(seed, "power_transform", {id});
  const Eigen::Vector3d axis(random.normal(), random.normal(), random.normal());
  Pose3 pose = Pose3::Identity();
  pose.linear() = Eigen::AngleAxisd(random.uniform(0.0, kPi), axis.normalized()).toRotationMatrix();
  for (int k = 0; k < 3; ++k) pose.translation()[k] = random.uniform(-1.0, 1.0);
  return pose;
}

double distance_of(const Pose3& a, const Pose3& b) { return (a.matrix() - b.matrix()).norm(); }

Pose3 product_of(const Pose3& factor, int count) {
  Pose3 product = Pose3::Identity();
  for (int k = 0; k < count; ++k) product = product * factor;
  return product;
}

PowerErrors mean_power_errors(std::uint64_t seed) {
  PowerErrors errors;
  std::vector<Pose3> transforms;
  for (std::uint64_t id = 0; id < kTransforms; ++id) {
    transforms.push_back(random_transform(seed, id));
  }
  for (int k = 1; k <= kPowers; ++k) {
    const double u = static_cast<double>(k) / kPowers, part = 1.0 / k;
    double inverse = 0.0, product = 0.0;
    for (const Pose3& pose : transforms) {
      inverse += distance_of(pose_power(pose_power(pose, u), 1.0 / u), pose) / kTransforms;
      product += distance_of(product_of(pose_power(pose, part), k), pose) / kTransforms;
    }
    errors.inverse_power.emplace_back(u, inverse);
    errors.product.emplace_back(part, product);
  }
  return errors;
}

double largest_error(const std::vector<Eigen::Vector2d>& curve) {
  double largest = 0.0;
  for (const Eigen::Vector2d& point : curve) largest = std::max(largest, point.y());
  return largest;
}

std::vector<Pose3> frames_between(const Pose3& a, const Pose3& b, int count) {
  std::vector<Pose3> frames;
  for (int k = 0; k < count; ++k) {
    const double u = k / (count - 1.0);
    frames.push_back(pose_power(a, 1.0 - u) * pose_power(b, u));
  }
  return frames;
}

Table power_rows(const PowerErrors& errors) {
  Table rows({{"curve", "", "inverse_power or product", std::vector<std::string>{}},
              {"u", "", "power", std::vector<double>{}},
              {"error", "", "mean Frobenius norm over the transforms", std::vector<double>{}}});
  for (const auto& p : errors.inverse_power) rows.add_row("inverse_power", p.x(), p.y());
  for (const auto& p : errors.product) rows.add_row("product", p.x(), p.y());
  return rows;
}

FigureResults make_power_figures(const RunRequest& request, const std::filesystem::path& figures) {
  const PowerErrors errors =
      mean_power_errors(static_cast<std::uint64_t>(request.resolved.scenario.seed));
  const Pose3 a = pose_from_rpy({0.0, 0.0, 0.0}, 0.0, 0.0, 0.2);
  const Pose3 b = pose_from_rpy({6.0, 4.0, 2.5}, 0.5, -0.6, 2.2);
  FigureResults results;
  results.table = "powers";
  results.facts = {{"power, then inverse power: largest mean error",
                    "",
                    largest_error(errors.inverse_power),
                    {},
                    4},
                   {"power 1/n, then n factors: largest mean error", "",
                    largest_error(errors.product), kPaperProductError, 4}};
  results.figures = {draw_power_frames(figures, frames_between(a, b, 11)),
                     draw_power_errors(figures, errors, kPaperProductError)};
  results.notes = {
      "Without a series for small angles the power is exact to rounding; the paper's "
      "error of 4.8e-3 is one of its program, not of its equations."};
  results.protocol = {
      fmt::format("Errors: Frobenius norm of the difference of the 4 × 4 matrices, mean over {} "
                  "transforms: p uniform in [−1, 1]³, axis uniform over the sphere, angle uniform "
                  "in [0, π].",
                  kTransforms),
      "Frames: τ_a^(1−u) τ_b^u for u = 0, 0.1 … 1 (Fig. 2 of the paper)."};
  results.rows = power_rows(errors);
  return results;
}

}  // namespace

RunOutcome run_power_experiment(const RunRequest& request) {
  return run_figure_experiment(request, make_power_figures);
}

}  // namespace honka::eval
