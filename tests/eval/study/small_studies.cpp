#include "tests/eval/study/small_studies.h"

#include <map>

#include "tests/eval/io/temporary_folder.h"

namespace honka::test {
namespace {

constexpr const char* kSmallSighting = R"(
experiment = "sighting"
forest.density_per_ha = 500
forest.spacing.strauss.sweeps = 5
sighting.map.stems = 400
sighting.noise_m = 0.02
variants.methods = "li2020, consensus"
study.worlds = 2
)";

constexpr const char* kSmallWindow = R"(
experiment = "localization"
forest.width_m = 60
forest.length_m = 60
forest.density_per_ha = 500
forest.spacing.strauss.sweeps = 5
forest.undergrowth.saplings_per_ha = 20
harvester.work_cycle = false
harvester.occluders = false
stems.height_band = true
stems.centre = "bias_corrected"
map.source = "inventory"
map.inventory.position_error_m = 0.02
protocol.path_length_m = 20
protocol.window_frames = 2
variants.methods = "li2020, consensus"
study.worlds = 2
)";

constexpr const char* kSmallLink = R"(
experiment = "link"
forest.width_m = 40
forest.length_m = 30
forest.density_per_ha = 800
forest.spacing.strauss.sweeps = 5
harvester.work_cycle = false
harvester.occluders = false
harvester.drive_speed_m_s = 2
harvester.acceleration_m_s2 = 4
stems.height_band = true
protocol.path_length_m = 5
link.study.methods = "chain, pose_graph"
link.jitter_s = 0.2
study.worlds = 2
)";

}  // namespace

eval::Scenario small_study(const std::string& experiment,
                           const std::vector<std::string>& overrides) {
  const std::map<std::string, const char*> known = {
      {"sighting", kSmallSighting}, {"localization", kSmallWindow}, {"link", kSmallLink}};
  INFO("a kind of trial needs a small scenario here: " << experiment);
  REQUIRE(known.count(experiment) == 1);
  const TemporaryFolder folder;
  const auto file = folder / "small.toml";
  std::ofstream(file) << known.at(experiment);
  return eval::load_scenario(file, overrides).scenario;
}

}  // namespace honka::test
