#include "tests/eval/study/fake_study.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <stdexcept>
#include <thread>

namespace honka::test {
namespace {

using eval::MeasureKind;
using eval::MethodResult;

void go_wrong(std::int64_t trial) {
  if (trial == 3) throw std::runtime_error("no forest\there");
  if (trial == 4) {
    std::fprintf(stderr, "progress\nfake: check failed\n");
    std::abort();
  }
  if (trial == 5) {
    for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  constexpr std::size_t kBlock = 1 << 26;
  if (trial == 6) {
    // Asked for and not touched: the limit counts addresses, and pages take their time.
    std::vector<std::unique_ptr<char[]>> blocks;
    for (;;) blocks.push_back(std::make_unique_for_overwrite<char[]>(kBlock));
  }
}

class FakeSubject : public eval::StudySubject {
 public:
  FakeSubject(double noise_m, bool harmless) : noise_m_(noise_m), harmless_(harmless) {}

  std::vector<MethodResult> run(std::int64_t trial) override {
    if (!harmless_ && noise_m_ > 0.15) go_wrong(trial);
    const double success = trial % 7 == 0 ? 0.0 : 1.0;
    const double missing = std::numeric_limits<double>::quiet_NaN();
    const double error_m = noise_m_ * std::sqrt(static_cast<double>(trial + 1));
    return {{"a", {success, success == 1.0 ? error_m : missing, 0.1}},
            {"b", {1.0, error_m / 3.0, 0.2}}};
  }

 private:
  double noise_m_;
  bool harmless_;
};

eval::StudyKind fake_kind(std::unique_ptr<eval::StudySubject> (*make)(const eval::Scenario&)) {
  return {"sighting",
          "fake",
          {{"success", "", "Success", MeasureKind::kRate, false},
           {"translation_error_m", "m", "Error", MeasureKind::kError, true},
           {"match_ms", "ms", "Time", MeasureKind::kTime, true}},
          [](const eval::Scenario&) {
            return std::vector<std::string>{"a", "b"};
          },
          make};
}

template <bool kHarmless>
std::unique_ptr<eval::StudySubject> make_fake(const eval::Scenario& scenario) {
  return std::make_unique<FakeSubject>(scenario.sighting.detector.noise_m, kHarmless);
}

}  // namespace

eval::Study fake_study(const TemporaryFolder& folder, std::int64_t trials, bool harmless,
                       const std::string& more) {
  static const eval::StudyKind kHarmless = fake_kind(make_fake<true>);
  static const eval::StudyKind kHarmful = fake_kind(make_fake<false>);
  const std::filesystem::path file = folder.path() / "fake.toml";
  std::ofstream(file) << "experiment = \"sighting\"\n[study]\nworlds = 3\n"
                      << "[study.vary]\nsighting.noise_m = [0.1, 0.2]\n"
                      << more;
  eval::Study study = eval::load_study(file, {}, trials);
  study.kind = harmless ? &kHarmless : &kHarmful;
  study.methods = {"a", "b"};
  return study;
}

}  // namespace honka::test
