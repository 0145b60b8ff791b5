#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algo/slam/registration/registration.h"
#include "eval/io/table.h"
#include "eval/report/summary.h"
#include "eval/run/experiment.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// One registration of two key frames, with its time and whether it is right.
struct RegistrationRun {
  std::int64_t trial = 0;
  std::size_t target = 0, source = 0;  ///< places in the drive
  Registration result;
  double time_ms = 0.0;   ///< wall clock on one thread
  bool is_right = false;  ///< within 0.5 m and 2.5° of the truth
};

/// Two clouds and where the search begins.
struct RegistrationTask {
  std::int64_t trial = 0;
  std::size_t target = 0, source = 0;
  Pose3 T_target_source_guess = Pose3::Identity();
};

using RegisterFrames = std::function<Registration(
    const SparseFrame& target, const SparseFrame& source, const Pose3& T_target_source_guess)>;

/// Runs tasks one after the other, so that times do not disturb each other.
[[nodiscard]] std::vector<RegistrationRun> run_registrations(
    const SlamDrive& drive, const std::vector<RegistrationTask>& tasks,
    const RegisterFrames& register_frames);

/// What became of many runs of one way to register.
struct RegistrationSummary {
  std::string name;
  std::vector<RegistrationRun> runs;

  [[nodiscard]] double mean_nodes() const;
  [[nodiscard]] double time_percentile_ms(double percent) const;
  [[nodiscard]] double mean_time_ms() const;
  [[nodiscard]] std::int64_t count(bool (*holds)(const RegistrationRun& run)) const;
};

/// Adds the runs to the summary of that name.
void add_runs(std::vector<RegistrationSummary>& summaries, const std::string& name,
              std::vector<RegistrationRun> runs);

/// {p50, p95}; null where there were no runs.
[[nodiscard]] Json time_json(const RegistrationSummary& summary);

/// One row a run; the times are no part of the digest.
[[nodiscard]] Table registration_rows(const std::vector<RegistrationSummary>& summaries);

/// What an experiment with one table hands to its writer.
struct RegistrationReport {
  std::string table;  ///< name in summary.json
  SummaryTable json;
  ReportTable shown;
  std::vector<std::string> protocol;
  Table rows;
};

/// Writes the folder of a run: summary.json, trials.h5, report.html.
[[nodiscard]] RunOutcome write_registration_report(const RunRequest& request,
                                                   const RegistrationReport& report);

}  // namespace honka::eval
