#include "eval/metrics/stem_scores.h"

#include <algorithm>
#include <tuple>

#include "algo/geometry/kdtree.h"
#include "algo/types/check.h"
#include "eval/metrics/statistics.h"

namespace honka::eval {
namespace {

std::optional<double> ratio(std::int64_t part, std::int64_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

std::vector<double> ranges_of(const StemSet& stems, const Eigen::Vector2d& sensor_m) {
  if (!stems.ranges_m.empty()) {
    HONKA_CHECK(stems.ranges_m.size() == stems.positions_m.size(), "one range a stem, or none");
    return stems.ranges_m;
  }
  std::vector<double> ranges;
  for (const Eigen::Vector2d& p : stems.positions_m) ranges.push_back((p - sensor_m).norm());
  return ranges;
}

DetectionScore count(const std::vector<double>& found_range_m,
                     const std::vector<double>& truth_range_m, const std::vector<StemPair>& pairs,
                     double low_m, double high_m) {
  const auto inside = [&](double range_m) { return range_m >= low_m && range_m < high_m; };
  DetectionScore score;
  score.found = std::count_if(found_range_m.begin(), found_range_m.end(), inside);
  score.truth = std::count_if(truth_range_m.begin(), truth_range_m.end(), inside);
  for (const StemPair& pair : pairs) {
    score.found_matched += inside(found_range_m[pair.found]) ? 1 : 0;
    score.truth_matched += inside(truth_range_m[pair.truth]) ? 1 : 0;
  }
  return score;
}

void score_positions(StemScores& scores, const StemSet& found, const StemSet& truth,
                     const Eigen::Vector2d& sensor_m) {
  std::vector<double> distances, radial, tangential;
  for (const StemPair& pair : scores.pairs) {
    const Eigen::Vector2d error = found.positions_m[pair.found] - truth.positions_m[pair.truth];
    const Eigen::Vector2d ray = (truth.positions_m[pair.truth] - sensor_m).stableNormalized();
    distances.push_back(pair.distance_m);
    radial.push_back(ray.dot(error));
    tangential.push_back(ray.x() * error.y() - ray.y() * error.x());
  }
  scores.position_rmse_m = rmse(distances);
  scores.radial_bias_m = mean(radial);
  scores.tangential_bias_m = mean(tangential);
}

void score_dbh(StemScores& scores, const StemSet& found, const StemSet& truth) {
  if (found.dbh_m.empty() || truth.dbh_m.empty()) return;
  HONKA_CHECK(found.dbh_m.size() == found.positions_m.size() &&
                  truth.dbh_m.size() == truth.positions_m.size(),
              "one DBH a stem, or none");
  std::vector<double> errors;
  for (const StemPair& pair : scores.pairs) {
    const auto& found_m = found.dbh_m[pair.found];
    const auto& truth_m = truth.dbh_m[pair.truth];
    if (found_m && truth_m) errors.push_back(*found_m - *truth_m);
  }
  scores.dbh_bias_m = mean(errors);
  scores.dbh_rmse_m = rmse(errors);
  scores.dbh_pairs = static_cast<std::int64_t>(errors.size());
}

}  // namespace

std::optional<double> DetectionScore::precision() const { return ratio(found_matched, found); }

std::optional<double> DetectionScore::recall() const { return ratio(truth_matched, truth); }

std::optional<double> DetectionScore::f1() const {
  const auto p = precision(), r = recall();
  if (!p || !r || *p + *r == 0.0) return std::nullopt;
  return 2.0 * *p * *r / (*p + *r);
}

std::vector<StemPair> match_stems(std::span<const Eigen::Vector2d> found_m,
                                  std::span<const Eigen::Vector2d> truth_m, double gate_m) {
  const KdTree2 tree(truth_m);
  std::vector<StemPair> candidates;
  for (std::size_t i = 0; i < found_m.size(); ++i) {
    for (const std::uint32_t k : tree.within(found_m[i], gate_m)) {
      candidates.push_back({i, k, (found_m[i] - truth_m[k]).norm()});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const StemPair& a, const StemPair& b) {
    return std::tie(a.distance_m, a.found, a.truth) < std::tie(b.distance_m, b.found, b.truth);
  });
  std::vector<bool> found_taken(found_m.size(), false), truth_taken(truth_m.size(), false);
  std::vector<StemPair> pairs;
  for (const StemPair& pair : candidates) {
    if (found_taken[pair.found] || truth_taken[pair.truth]) continue;
    found_taken[pair.found] = truth_taken[pair.truth] = true;
    pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const StemPair& a, const StemPair& b) { return a.found < b.found; });
  return pairs;
}

StemScores score_stems(const StemSet& found, const StemSet& truth, const Eigen::Vector2d& sensor_m,
                       double gate_m, const std::vector<double>& range_edges_m) {
  StemScores scores;
  scores.pairs = match_stems(found.positions_m, truth.positions_m, gate_m);
  const auto matched = static_cast<std::int64_t>(scores.pairs.size());
  scores.all = {static_cast<std::int64_t>(found.positions_m.size()), matched,
                static_cast<std::int64_t>(truth.positions_m.size()), matched};
  const auto found_range_m = ranges_of(found, sensor_m);
  const auto truth_range_m = ranges_of(truth, sensor_m);
  for (std::size_t bin = 0; bin + 1 < range_edges_m.size(); ++bin) {
    const double low_m = range_edges_m[bin], high_m = range_edges_m[bin + 1];
    scores.by_range.push_back(
        {low_m, high_m, count(found_range_m, truth_range_m, scores.pairs, low_m, high_m)});
  }
  score_positions(scores, found, truth, sensor_m);
  score_dbh(scores, found, truth);
  return scores;
}

}  // namespace honka::eval
