#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace honka::eval {

/// A scenario file and what the command line puts on top of it.
struct ScenarioArguments {
  std::filesystem::path scenario;
  std::vector<std::string> overrides;  ///< "key=value"
  std::optional<std::int64_t> seed;

  /// Overrides with the seed among them.
  [[nodiscard]] std::vector<std::string> all_overrides() const;
};

struct RunArguments : ScenarioArguments {
  int threads = 0;                    ///< 0: as many as there are cores
  std::optional<std::int64_t> trial;  ///< this one alone
  std::filesystem::path out;          ///< empty: results/<path of the scenario under scenarios/>
};

struct SimulateArguments : ScenarioArguments {
  int threads = 0;
  std::filesystem::path out;
};

struct LocateArguments {
  std::filesystem::path map;
  std::vector<std::filesystem::path> locals;
  std::string method = "li2020";
  double tolerance_m2 = 4.5;
  std::optional<std::string> stars;  ///< plane or space; nothing: plane
  std::optional<std::string> prior;  ///< "x,y,radius"
  std::filesystem::path index;       ///< file of the map's index; empty: none
  bool json = false;
};

struct UpdateMapArguments {
  std::filesystem::path map, out;
  std::vector<std::filesystem::path> locals;  ///< in the order in which they were seen
  std::string method = "consensus";
  double tolerance_m2 = 4.5;
  double range_m = 25.0, field_of_view_deg = 210.0;  ///< of the lists, as far as they are counted
  std::int64_t every = 25;                           ///< lists from one update to the next
  bool json = false;
};

struct RegisterArguments {
  std::filesystem::path target, source;
  std::string method;
  std::string mode = "certify";
  double inlier_share = 0.4;
  bool json = false;
};

struct SlamArguments {
  std::filesystem::path frames, chain, out;     ///< chain empty: it is made
  std::vector<std::filesystem::path> vehicles;  ///< frames of other vehicles on the same site
  std::string method = "landmark_ba";
  bool propose = false;  ///< also pairs that the poses do not show
};

struct ScoreArguments {
  std::filesystem::path recording, poses, stems;
};

struct EvaluateArguments {
  std::filesystem::path truth, estimate;
  std::string format = "tum";
  std::string align = "none";
  double max_time_difference_s = 0.02;
  std::optional<std::string> delta;  ///< nothing: 1s, or 1f where the format has no times
  bool all_pairs = false;
  bool json = false;
  std::filesystem::path plot;  ///< folder of the figures; empty: none
};

struct CheckArguments {
  std::vector<std::string> names;     ///< references or folders of them; empty: all
  std::optional<std::string> accept;  ///< this scenario's results become its reference
  std::string why;                    ///< of accept
  bool run = false;                   ///< make results that are missing or of another build
  int threads = 0;                    ///< of run; 0: as many as there are cores
};

/// Each verb returns the exit code of the program; the user's mistakes come as UserError.
int run_verb(const RunArguments& arguments);
int simulate_verb(const SimulateArguments& arguments);
int locate_verb(const LocateArguments& arguments);
int update_map_verb(const UpdateMapArguments& arguments);
int register_verb(const RegisterArguments& arguments);
int slam_verb(const SlamArguments& arguments);
int score_verb(const ScoreArguments& arguments);
int evaluate_verb(const EvaluateArguments& arguments);
int check_verb(const CheckArguments& arguments);
int report_verb(const std::filesystem::path& folder);
int scenario_check_verb(const ScenarioArguments& arguments);
int scenario_show_verb(const ScenarioArguments& arguments);
int scenario_diff_verb(const ScenarioArguments& arguments, const std::filesystem::path& other);
int help_verb(const std::string& topic);

}  // namespace honka::eval
