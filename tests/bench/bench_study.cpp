// Studies: what a second core gains, what a trial costs beside its work, and a merge.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "algo/types/random.h"
#include "eval/study/run_study.h"

using namespace honka;
using namespace honka::eval;

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kStudySeed = 5;

/// Trials that only reckon, `kDraws` random numbers each.
template <int kDraws>
class Reckoning : public StudySubject {
 public:
  std::vector<MethodResult> run(std::int64_t trial) override {
    RandomStream random(kStudySeed, "bench_study", {static_cast<std::uint64_t>(trial)});
    double sum = 0.0;
    for (int i = 0; i < kDraws; ++i) sum += random.uniform(0.0, 1.0);
    return {{"sum", {sum > 0.5 * kDraws ? 1.0 : 0.0, sum}}};
  }
};

template <int kDraws>
StudyKind reckoning_kind() {
  StudyKind kind;
  kind.experiment = "sighting";
  kind.measures = {{"success", "", "High sums", MeasureKind::kRate, false},
                   {"sum", "", "Sum", MeasureKind::kValue, false}};
  kind.methods = [](const Scenario&) { return std::vector<std::string>{"sum"}; };
  kind.make = [](const Scenario&) -> std::unique_ptr<StudySubject> {
    return std::make_unique<Reckoning<kDraws>>();
  };
  return kind;
}

/// A folder that vanishes with the measurement, and the scenario of a study in it.
class StudyPlace {
 public:
  explicit StudyPlace(const std::string& more) {
    static int count = 0;
    path_ = fs::temp_directory_path() /
            ("honka-bench-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    fs::create_directories(path_);
    std::ofstream(path_ / "study.toml") << "experiment = \"sighting\"\n" << more;
  }
  ~StudyPlace() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  StudyPlace(const StudyPlace&) = delete;
  StudyPlace& operator=(const StudyPlace&) = delete;

  [[nodiscard]] Study study() const { return load_study(path_ / "study.toml"); }
  [[nodiscard]] StudyFolder folder(const std::string& name) const {
    return StudyFolder(path_ / name);
  }

 private:
  fs::path path_;
};

template <class Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// 200 trials of some 20 ms by one worker and by two, in turn; perfect is half the time. The best
/// of three of each: whatever else the machine does only adds.
void BM_TwoWorkers(benchmark::State& state) {
  const StudyPlace place("[study]\ntrials = 200\nvary.sighting.noise_m = [0.1]\n");
  static const StudyKind kKind = reckoning_kind<2000000>();
  Study study = place.study();
  study.kind = &kKind;
  study.methods = {"sum"};
  double one_s = 1e9, two_s = 1e9;
  int round = 0;
  for (auto _ : state) {
    const auto folder = [&](int workers) {
      return place.folder(std::to_string(workers) + "-" + std::to_string(round));
    };
    one_s = std::min(one_s, seconds_of([&] { run_shard(folder(1), study, {}, 1); }));
    two_s = std::min(two_s, seconds_of([&] { run_shard(folder(2), study, {}, 2); }));
    ++round;
  }
  state.counters["one_s"] = one_s;
  state.counters["two_s"] = two_s;
  state.counters["efficiency"] = one_s / (2.0 * two_s);
}
BENCHMARK(BM_TwoWorkers)->Iterations(3)->Unit(benchmark::kSecond);

/// Trials without any work: handing out, journal, shard file.
void BM_EmptyTrials(benchmark::State& state) {
  constexpr double kTrials = 5000.0;
  const StudyPlace place("[study]\ntrials = 5000\nvary.sighting.noise_m = [0.1]\n");
  static const StudyKind kKind = reckoning_kind<1>();
  Study study = place.study();
  study.kind = &kKind;
  study.methods = {"sum"};
  double all_s = 0.0;
  for (auto _ : state) all_s = seconds_of([&] { run_shard(place.folder("out"), study, {}, 1); });
  state.counters["ms_a_trial"] = 1e3 * all_s / kTrials;
}
BENCHMARK(BM_EmptyTrials)->Iterations(1)->Unit(benchmark::kSecond);

TrialRecord made_up_record(const Study& study, TrialId id) {
  const auto point = static_cast<std::uint64_t>(id.point);
  const auto trial = static_cast<std::uint64_t>(id.trial);
  RandomStream random(kStudySeed, "bench_merge", {point, trial});
  TrialRecord record;
  record.id = id;
  for (const std::string& method : study.methods) {
    MethodResult result{method, {}};
    for (const Measure& measure : study.kind->measures) {
      const double draw = random.uniform(0.0, 1.0);
      result.values.push_back(measure.kind == MeasureKind::kRate ? std::round(draw) : draw);
    }
    record.results.push_back(std::move(result));
  }
  return record;
}

/// 100,000 trials by two methods in seven shards: tables, figures and report with them.
void BM_Merge100000(benchmark::State& state) {
  const StudyPlace place(
      "variants.methods = \"li2020, consensus\"\n[study]\ntrials = 10000\n"
      "vary.sighting.noise_m = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]\n");
  const Study study = place.study();
  const StudyFolder folder = place.folder("out");
  for (std::int64_t index = 0; index < 7; ++index) {
    const Shard shard{index, 7};
    folder.enter(study, shard);
    std::vector<TrialRecord> records;
    for (const TrialBatch& batch : batches_of(study, shard)) {
      for (const TrialId id : batch) records.push_back(made_up_record(study, id));
    }
    write_shard(folder, study, shard, std::move(records));
  }
  for (auto _ : state) benchmark::DoNotOptimize(merge_study(folder, study, "honka study"));
}
BENCHMARK(BM_Merge100000)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
