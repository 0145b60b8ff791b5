#include "eval/run/trajectory_json.h"

#include <nlohmann/json.hpp>

namespace honka::eval {
namespace {

nlohmann::ordered_json statistics_json(const std::vector<double>& errors) {
  const auto s = trajectory_statistics(errors);
  if (!s) return nullptr;
  return {{"rmse", s->rmse}, {"mean", s->mean}, {"median", s->median}, {"std", s->std},
          {"min", s->min},   {"max", s->max},   {"sse", s->sse}};
}

}  // namespace

nlohmann::ordered_json errors_json(const TrajectoryErrors& errors) {
  return {{"translation_m", statistics_json(errors.translation_m)},
          {"rotation_deg", statistics_json(errors.rotation_deg)}};
}

}  // namespace honka::eval
