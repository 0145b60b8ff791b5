#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "algo/types/lidar_model.h"
#include "algo/types/pose.h"
#include "algo/types/stem.h"
#include "sim/world/recording.h"

namespace honka::eval {

inline constexpr std::int64_t kRecordingSchemaVersion = 1;

/// Truth: the stems of the stand in the world frame and their tree ids (Label::owner).
struct StemTruth {
  StemMap stems_in_world;
  std::vector<std::int32_t> ids;  ///< as many as stems

  bool operator==(const StemTruth&) const = default;
};

/// Truth: poses of the lidar at some times of one sweep, increasing.
struct SweepKnots {
  std::vector<double> times_s;
  std::vector<Pose3> T_world_lidar;  ///< as many as times
};

/// Writes recording.h5 sweep by sweep in bounded memory (some 3 MB), whatever its length.
///
/// Scans (/sensor, /sweeps, /returns) and truth (/truth) are apart; the layout is in the folder's
/// README. The file appears under its name at commit(); without it nothing is left. UserError when
/// it cannot be written.
class RecordingWriter {
 public:
  /// `T_vehicle_lidar`: mounting of the sensor. `context`: attributes of /context.
  RecordingWriter(const std::filesystem::path& path, const LidarModel& model,
                  const Pose3& T_vehicle_lidar, const StemTruth& stems,
                  const std::map<std::string, std::string>& context = {});
  ~RecordingWriter();
  RecordingWriter(RecordingWriter&&) noexcept;
  RecordingWriter& operator=(RecordingWriter&&) noexcept;

  /// One truth a return and one time a pose, else a failed check.
  void append(const sim::TruthfulSweep& sweep, const std::vector<Pose3>& T_world_lidar_at_knots,
              const std::vector<double>& knot_times_s);
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads a recording back bit for bit, one sweep at a time.
///
/// UserError that names the file and what to do when it is missing, truncated, foreign, or of a
/// newer schema. Index out of range is a failed check.
class RecordingReader {
 public:
  explicit RecordingReader(const std::filesystem::path& path);
  ~RecordingReader();
  RecordingReader(RecordingReader&&) noexcept;
  RecordingReader& operator=(RecordingReader&&) noexcept;

  [[nodiscard]] const LidarModel& model() const;
  [[nodiscard]] const Pose3& T_vehicle_lidar() const;
  [[nodiscard]] std::size_t sweeps() const;
  [[nodiscard]] Sweep sweep(std::size_t i) const;

  [[nodiscard]] std::vector<sim::ReturnTruth> truth(std::size_t i) const;
  [[nodiscard]] SweepKnots poses(std::size_t i) const;
  [[nodiscard]] StemTruth stems() const;
  [[nodiscard]] std::map<std::string, std::string> context() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace honka::eval
