#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/random.h"
#include "eval/metrics/joint_bootstrap.h"

using namespace honka::eval;

namespace {

using Sums = std::span<const double>;

/// Rows (v², 1) of normal errors with s.d. 2.
std::vector<double> rows_of_squares(int n) {
  honka::RandomStream random(5, "errors");
  std::vector<double> rows;
  for (int i = 0; i < n; ++i) {
    rows.push_back(std::pow(random.normal(0.0, 2.0), 2));
    rows.push_back(1.0);
  }
  return rows;
}

JointBootstrap bootstrap_of(const std::vector<double>& rows, std::size_t columns) {
  const std::size_t n = JointBootstrap::drawn_rows(rows.size() / columns);
  return JointBootstrap(rows, columns, BootstrapDraws(n, {}));
}

double rms_of_sums(Sums sums) { return std::sqrt(sums[0] / sums[1]); }

}  // namespace

TEST_CASE("the bootstrap of an RMSE has the width that its squares give it") {
  // To first order the s.d. of √(mean of squares) is that of the squares over 2 RMS √n.
  for (const int n : {300, 20000}) {  // drawn one by one, and in runs of 50
    const std::vector<double> rows = rows_of_squares(n);
    std::vector<double> squares;
    for (std::size_t k = 0; k < rows.size(); k += 2) squares.push_back(rows[k]);
    const auto interval = bootstrap_of(rows, 2).interval(rms_of_sums);
    REQUIRE(interval);
    const double rms = std::sqrt(*mean(squares));
    const double half = 1.96 * *standard_deviation(squares) / (2.0 * rms * std::sqrt(n));
    CHECK(0.5 * (interval->high - interval->low) == Approx(half).epsilon(0.1));
    CHECK(interval->low < rms);
    CHECK(interval->high > rms);
  }
}

TEST_CASE("the bootstrap of equal rows is a point, of one row nothing") {
  const std::vector<double> rows = {9.0, 1.0, 9.0, 1.0, 9.0, 1.0};
  const auto interval = bootstrap_of(rows, 2).interval(rms_of_sums);
  REQUIRE(interval);
  CHECK(interval->low == 3.0);
  CHECK(interval->high == 3.0);
  CHECK_FALSE(bootstrap_of({9.0, 1.0}, 2).interval(rms_of_sums));
  CHECK_FALSE(bootstrap_of({}, 2).interval(rms_of_sums));
}

TEST_CASE("a bootstrap without a value in most draws is nothing") {
  const std::vector<double> none = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  CHECK_FALSE(bootstrap_of(none, 2).interval(rms_of_sums));
  std::vector<double> rare(200, 0.0);  // one value in a hundred rows: in 63 % of the draws
  rare[0] = 4.0;
  rare[1] = 1.0;
  const auto interval = bootstrap_of(rare, 2).interval(rms_of_sums);
  REQUIRE(interval);
  CHECK(interval->low == 2.0);
  CHECK(interval->high == 2.0);
}

TEST_CASE("statistics of one bootstrap share their draws") {
  // The second column is the first plus 1 in every row, so their means always differ by 1.
  std::vector<double> rows;
  honka::RandomStream random(6, "pairs");
  for (int i = 0; i < 50; ++i) {
    const double value = random.normal();
    rows.insert(rows.end(), {value, value + 1.0, 1.0});
  }
  const JointBootstrap bootstrap = bootstrap_of(rows, 3);
  const auto difference = bootstrap.interval([](Sums s) { return s[1] / s[2] - s[0] / s[2]; });
  REQUIRE(difference);
  CHECK(difference->low == Approx(1.0).margin(1e-12));
  CHECK(difference->high == Approx(1.0).margin(1e-12));
  const auto again = bootstrap_of(rows, 3).interval([](Sums s) { return s[0]; });
  const auto first = bootstrap.interval([](Sums s) { return s[0]; });
  CHECK(again->low == first->low);
}

TEST_CASE("a resample holds as many rows as there are, each now and then") {
  const BootstrapDraws draws(20, {});
  REQUIRE(draws.resamples() == 2000);
  std::vector<double> sums(20, 0.0);
  for (std::size_t k = 0; k < draws.resamples(); ++k) {
    int drawn = 0;
    for (std::size_t i = 0; i < 20; ++i) {
      drawn += draws.times(k)[i];
      sums[i] += draws.times(k)[i];
    }
    CHECK(drawn == 20);
  }
  for (const double sum : sums) CHECK(sum == Approx(2000.0).margin(5.0 * std::sqrt(2000.0)));
}
