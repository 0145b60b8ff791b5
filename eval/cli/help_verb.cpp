#include <fmt/core.h>

#include <map>

#include "algo/localize/matcher.h"
#include "algo/types/user_error.h"
#include "eval/cli/verbs.h"
#include "eval/config/scenario.h"
#include "eval/run/experiment.h"

namespace honka::eval {
namespace {

constexpr const char* kOverview =
    R"(honka simulates a forest, a harvester and its lidar, runs localization
on the scans and judges it against truth.

First steps
  honka run scenarios/quick.toml            half a minute: one stand, a table, a report
  honka run scenarios/li2020/table1.toml    Table 1 of Li et al. 2020 at full size
  honka locate MAP.csv LOCAL.csv            find your own stem list in your own stem map

Verbs
  run SCENARIO         tables, figures and report into results/
  study SCENARIO       many trials at many points; shards, resume, clusters
  simulate SCENARIO    record scans and truth (HDF5)
  locate MAP LOCAL…    the pose of each local stem list in the map
  update-map MAP LOCAL… --out NEW the map after those lists: stems gone and new
  register TARGET SOURCE          lay one sparse cloud onto another
  slam FRAMES          key frames of stems into one map: trajectory, stems, quality
  score RECORDING POSES [STEMS]   judge poses and stems made elsewhere
  evaluate TRUTH ESTIMATE         APE and RPE of a trajectory (TUM, KITTI)
  check [NAME]         results against their references: which figures moved
  report DIR           write report.html of a results folder anew
  scenario check|show|diff FILE   read a scenario, list its keys, compare two
  help TOPIC           scenarios, experiments, formats, keys, or a verb

Exit codes: 0 done (a refusal is an answer), 1 a comparison failed, 2 your input, 3 unfinished.
)";

constexpr const char* kScenarios =
    R"(A scenario is one TOML file that fixes an experiment with its seed:

  experiment = "localization"
  trials = 3                      # stands
  [forest]
  density_per_ha = 500.0

Every key left out keeps its default. See all of them, with units, ranges and sources:
  honka scenario show scenarios/quick.toml
Change one for a run:
  honka run scenarios/quick.toml -s forest.density_per_ha=800 --out results/dense
The same scenario and seed give the same digits, whatever the threads.
)";

constexpr const char* kFormats =
    R"(Stem list (CSV)   '#' comments, a header, x_m,y_m and any of z_m,dbh_m,height_m; metres
Poses (TUM)       t x y z qx qy qz qw, T_world_lidar; seconds, metres
Poses (KITTI)     12 numbers a row, [R|t] by rows; honka evaluate alone
recording.h5      /sensor /sweeps /returns (u16 x 2 mm) and, apart, /truth
results folder    summary.json (tables, metrics, digest), trials.h5 (one row a trial, one a
                  localization), figures/ (NAME.gp redraws NAME), report.html
Frames            world, map: x east, y north, z up. lidar: x ahead, y left, z up. T_a_b maps
                  points given in b into a. Yaw counter-clockwise from x in (-pi, pi].
Open trials.h5    pandas.DataFrame({k: v[:] for k, v in h5py.File("trials.h5")["frames"].items()})
)";

constexpr const char* kLocate =
    R"(honka locate MAP.csv LOCAL.csv… [--method li2020|consensus] [--tolerance-m2 4.5]
             [--stars plane|space] [--prior x,y,radius] [--index FILE] [--json]

MAP.csv holds the stems of a map, each LOCAL.csv those seen from one place, with the sensor at the
origin and x ahead. The answer is T_map_local: x_map = R(yaw) x_local + t. Refused lists say why:
not_in_map, ambiguous, or too_few_stems (an empty list too). All lists share one graph or index.

--method   li2020     the paper's matcher of triangle stars, with its tolerance
           consensus  one frame, any map: weighs all stems, and says when two places fit
--stars    of li2020: plane (as left out), or space: stars of x_m, y_m and z_m, the height of each
           foot in map and lists, for a sensor that stands tilted by a slope; the lists are as it
           sees them, not levelled, and the answer has its z, roll and pitch, too
--prior    the sensor is within radius of (x, y), metres of the map; no answer lies outside
--index    of consensus: loaded where FILE holds MAP's index, else built and written there (the
           index of another map is replaced; a file that is no index is left alone: exit 2)
--json     one object a local file: local, method, verdict, accepted, x_m, y_m, yaw_rad, stems,
matches, agreeing, inliers, margin, time_ms; map_ms in the first. With --stars space also z_m,
roll_rad, pitch_rad: R = Rz(yaw) Ry(pitch) Rx(roll).
)";

constexpr const char* kUpdateMap =
    R"(honka update-map MAP.csv LOCAL.csv… --out NEW.csv [--method consensus|li2020]
                 [--range-m 25] [--view-deg 210] [--every 25] [--tolerance-m2 4.5] [--json]

Brings a stem map up to date after a thinning. Each LOCAL.csv (as of honka locate; in the order in
which they were seen) is found in the map as updated so far. By the accepted ones stems are retired
that were in view and missed, once the odds are 100 to 1 that they are gone, and stems join that
were seen again and again and are not in the map. NEW.csv is MAP.csv without the rows of retired
stems and with a row for each that joined (x_m,y_m; other cells empty); rows that stay keep every
column.

--range-m   up to which the lists are to be trusted: farther stems are neither retired nor added
--view-deg  of the sensor about its x axis: what lies outside is not missed
--every     lists from one update to the next; li2020 needs them more than consensus
--json      map, out, method, lists, accepted, refused, counted (views 2 m apart), stems_before,
            stems_after, retired (line, x_m, y_m, id), added (x_m, y_m), detection_rate by fifths of
            the range, views (local, verdict, counted)
A refused list is an answer (exit 0) and changes nothing; a few views change little.
)";

constexpr const char* kSlam =
    R"(honka slam FRAMES.csv[.gz] [--chain POSES] --out DIR
           [--method chain|paper|interpolate|pose_graph|landmark_ba] [--propose]
           [--vehicle FRAMES.csv]…

FRAMES holds one stem a row: frame,x_m,y_m,z_m (also x,y,z; other columns are left alone), in the
lidar's frame, x ahead, y left, z up. POSES holds T_first_frame, 12 numbers a frame ([R|t] by rows,
commas or blanks, no header); without it the chain is made from the frames.

--method   chain         the chain alone
           paper         the self-corrective loop of Nevalainen et al. 2021
           interpolate   chain re-registered, verified matches squeezed in one by one
           pose_graph    the same matches, all poses fitted at once
           landmark_ba   then poses and stems together (as left out)
--propose  pairs that the poses do not show are looked for too, by triangles of stems: for a drive
           that comes back after its chain has drifted away
--vehicle  another vehicle's frames on the same site, wherever it began: mapped alone, then joined
           where triangles of stems agree; trajectory_2.tum and so on, in the frame of FRAMES
DIR        trajectory.tum (time = frame number), stems.csv (x_m,y_m,z_m,observations,rmse_m),
           summary.json (blur, cluster RMSE, box dimension, matches, times, frames not placed)
)";

constexpr const char* kRegister =
    R"(honka register TARGET SOURCE --method icp|go_icp|landmarks [--mode certify|l0]
               [--inlier-share 0.4] [--json]

Lays the cloud SOURCE onto the cloud TARGET: x_target = R x_source + t. A cloud is a CSV file with
a header x_m,y_m or x_m,y_m,z_m (x,y,z too), one stem a row; without heights z is 0.
icp        trimmed ICP from the identity: for clouds that nearly fit already
go_icp     the best pose within 30 degrees and 5 m of the identity, by branch and bound.
           --mode certify proves that nothing there has an RMSE better by more than 0.05 m;
           --mode l0 tries ICP in every cell of a grid set by the distance between the stems
landmarks  any pose, without a guess: triangles of neighbouring stems vote
--inlier-share  part of SOURCE taken to have partners; the RMSE is over the best such part
status     registered; unverified: too few stems within 0.35 m of another; time_cap: the best of
           1 s, without a proof; too_few_points: under three, or on one line
--json     method, status, T_target_source (16 numbers by rows), rmse_m, overlap, inliers, share,
           lower_bound_m, gap_m, certified, nodes, time_ms
)";

constexpr const char* kStudy =
    R"(honka study SCENARIO [--trials N] [--shard i/N] [--threads T] [--out DIR] [-s key=value]…
honka study status|merge|retry-failed DIR
honka study sbatch SCENARIO --shards N

A study is a scenario with keys that vary; every combination is a point with as many trials:

  [study]
  trials = 200                    # at each point
  worlds = 4                      # forests that they share
  [study.vary]
  sighting.noise_m = [0.05, 0.1, 0.2]
  forest.spacing.process = "strauss, rows"    # texts: words

Trials of one number share forest, place and noise draws at every point and for every method.
--trials   more than before adds to what is there; --shard 2/7 runs the third part of seven
DIR        shards/ (each trial on disk as it ends), then summary.json, trials.h5, report.html

Whatever ends a study (Ctrl-C, kill -9, a full disk), the same command goes on from there. A trial
that throws, crashes, hangs past study.time_limit_s or runs out of memory is a row with its cause.
The digits are the same for any threads, shards and order.
One trial alone: honka run SCENARIO -s KEY=VALUE --trial N
)";

constexpr const char* kEvaluate =
    R"(honka evaluate TRUTH ESTIMATE [--format tum|kitti] [--align none|origin|yaw|se2|se3|sim3]
               [--max-time-difference 0.02] [--delta 1s|10m|1f] [--all-pairs] [--json]
               [--plot DIR]

TUM rows pair by time, KITTI rows by number. Rows t x y z alone give no rotation errors.
--align   none; origin: first poses equal; yaw: turn about z and translation; se2: turn, x and
          y; se3: rotation and translation; sim3: with scale. All but origin: least squares.
APE       distance and angle between poses that belong together, once aligned.
RPE       the same between motions over --delta. Seconds: from every pose to the estimated one
          nearest in time, but the last. Metres of the estimate's path, frames: end to end, or
          from every pose with --all-pairs. Without rotations: the difference of both
          displacements' lengths.
--json    align, associated, reference_poses, estimate_poses, ape, rpe {delta, unit, pairs}; in
          both translation_m, rotation_deg {rmse, mean, median, std, min, max, sse}; std over n.
--plot    trajectory.svg (from above, aligned), ape.svg and rpe.svg (errors over time) into DIR,
          each with the NAME.gp and NAME.dat that redraw it.
)";

constexpr const char* kCheck =
    R"(honka check [NAME]… [--run] [--threads N]
honka check --accept NAME --why TEXT

Holds results/NAME/ against results/reference/NAME.csv: each figure must lie within its tolerance.
NAME is a scenario's path under scenarios/, or a folder of them; left out: every reference.
exit 0  all figures within; "same digits" where the digest is the reference's, too
exit 1  some outside: listed with reference, tolerance and what they are now
exit 2  no results of this scenario; the line says which command makes them
--run     makes results first that are missing, or of another build of honka than this one
--accept  the results become the reference, with commit, date and reason. Results of a honka with
          changes that are not committed, or of a scenario with keys on top, are refused.
Tolerances come from the figures' own 95 % intervals where they have one; times are never compared.
Trajectories (rows "trajectory") are judged by the truth stored in results/reference/trajectories.
)";

void print_experiments() {
  fmt::print("experiment = \"…\" in a scenario may be:\n");
  for (const Experiment& experiment : experiments()) {
    fmt::print("  {:<14} {}\n", experiment.name, experiment.help);
  }
  fmt::print("\nlocalize.method may be:\n");
  for (const std::string& name : matcher_names()) fmt::print("  {}\n", name);
}

void print_keys() {
  for (const KeyEntry& entry : list_keys(Scenario{})) {
    fmt::print("{:<40} {:<12} {}\n", entry.key, format_value(entry.value),
               entry.help + (entry.unit.empty() ? "" : " [" + entry.unit + "]"));
  }
}

}  // namespace

int help_verb(const std::string& topic) {
  static const std::map<std::string, const char*> kTopics = {
      {"", kOverview},         {"scenarios", kScenarios}, {"scenario", kScenarios},
      {"run", kScenarios},     {"formats", kFormats},     {"simulate", kFormats},
      {"report", kFormats},    {"score", kFormats},       {"locate", kLocate},
      {"evaluate", kEvaluate}, {"register", kRegister},   {"slam", kSlam},
      {"check", kCheck},       {"study", kStudy},         {"update-map", kUpdateMap},
  };
  if (topic == "experiments") {
    print_experiments();
  } else if (topic == "keys") {
    print_keys();
  } else if (const auto it = kTopics.find(topic); it != kTopics.end()) {
    fmt::print("{}", it->second);
  } else {
    throw UserError("no help on \"" + topic +
                    "\"; there is help on scenarios, experiments, formats, keys and each verb");
  }
  return 0;
}

}  // namespace honka::eval
