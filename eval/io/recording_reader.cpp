#include <cmath>
#include <optional>

#include "algo/types/check.h"
#include "algo/types/user_error.h"
#include "eval/io/hdf5.h"
#include "eval/io/recording.h"

namespace honka::eval {
namespace {

constexpr std::size_t kPoseEntries = 12;

Pose3 pose_at(const std::vector<double>& numbers, std::size_t pose) {
  Pose3 T = Pose3::Identity();
  for (std::size_t i = 0; i < kPoseEntries; ++i) {
    T.matrix()(static_cast<int>(i / 4), static_cast<int>(i % 4)) = numbers[kPoseEntries * pose + i];
  }
  return T;
}

std::optional<double> unless_nan(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

[[noreturn]] void fail_damaged(const std::filesystem::path& path, const std::string& what) {
  throw UserError(path.string() + ": " + what + "; the recording is damaged, make it again");
}

void check_schema(const H5File& file, const std::filesystem::path& path) {
  if (!file.has_attribute("/", "format") ||
      file.string_attribute("/", "format") != "honka recording") {
    throw UserError(path.string() +
                    ": not a honka recording; make one with 'honka simulate SCENARIO --out FILE'");
  }
  const std::int64_t version = file.int_attribute("/", "schema_version");
  if (version > kRecordingSchemaVersion) {
    throw UserError(path.string() + ": schema version " + std::to_string(version) +
                    ", this honka reads up to " + std::to_string(kRecordingSchemaVersion) +
                    "; use a newer honka");
  }
}

LidarModel read_model(const H5File& file, const std::filesystem::path& path) {
  LidarModel model;
  model.name = file.string_attribute("/sensor", "name");
  model.firing_period_s = file.double_attribute("/sensor", "firing_period_s");
  model.rotation_rate_hz = file.double_attribute("/sensor", "rotation_rate_hz");
  model.range_resolution_m = file.double_attribute("/sensor", "range_resolution_m");
  model.max_range_m = file.double_attribute("/sensor", "max_range_m");
  const auto elevation = file.open_column<double>("/sensor/elevation_rad").read_all();
  const auto vertical = file.open_column<double>("/sensor/vertical_offset_m").read_all();
  const auto firing = file.open_column<double>("/sensor/firing_offset_s").read_all();
  if (vertical.size() != elevation.size() || firing.size() != elevation.size()) {
    fail_damaged(path, "the columns of /sensor differ in length");
  }
  for (std::size_t i = 0; i < elevation.size(); ++i) {
    model.lasers.push_back({elevation[i], vertical[i], firing[i]});
  }
  return model;
}

/// Rows [first[i], first[i + 1]) belong to sweep i.
struct Slice {
  std::uint64_t first = 0, count = 0;
};

}  // namespace

struct RecordingReader::State {
  explicit State(const std::filesystem::path& p) : path(p), file(H5File::open(p)) {
    check_schema(file, path);
    model = read_model(file, path);
    const auto mounting = file.open_column<double>("/sensor/T_vehicle_lidar").read_all();
    if (mounting.size() != kPoseEntries) fail_damaged(path, "/sensor/T_vehicle_lidar");
    T_vehicle_lidar = pose_at(mounting, 0);
    index = file.open_column<std::int64_t>("/sweeps/index").read_all();
    start_time_s = file.open_column<double>("/sweeps/start_time_s").read_all();
    start_azimuth_rad = file.open_column<double>("/sweeps/start_azimuth_rad").read_all();
    first_return = file.open_column<std::uint64_t>("/sweeps/first_return").read_all();
    range = file.open_column<std::uint16_t>("/returns/range_ticks");
    reflectivity = file.open_column<std::uint8_t>("/returns/reflectivity");
    laser = file.open_column<std::uint8_t>("/returns/laser");
    echo = file.open_column<std::uint8_t>("/returns/echo");
    time_offset_ns = file.open_column<std::uint32_t>("/returns/time_offset_ns");
    check_offsets();
  }

  void check_offsets() const {
    const std::size_t n = index.size();
    bool good = first_return.size() == n + 1 && start_time_s.size() == n &&
                start_azimuth_rad.size() == n && first_return.back() == range.rows();
    for (std::size_t i = 0; good && i < n; ++i) good = first_return[i] <= first_return[i + 1];
    if (!good) fail_damaged(path, "the columns of /sweeps do not agree");
  }

  [[nodiscard]] Slice returns_of(std::size_t sweep) const {
    HONKA_CHECK(sweep < index.size(), "no such sweep");
    return {first_return[sweep], first_return[sweep + 1] - first_return[sweep]};
  }

  std::filesystem::path path;
  H5File file;
  LidarModel model;
  Pose3 T_vehicle_lidar;
  std::vector<std::int64_t> index;
  std::vector<double> start_time_s, start_azimuth_rad;
  std::vector<std::uint64_t> first_return;
  H5Column<std::uint16_t> range;
  H5Column<std::uint8_t> reflectivity, laser, echo;
  H5Column<std::uint32_t> time_offset_ns;
};

RecordingReader::RecordingReader(const std::filesystem::path& path)
    : state_(std::make_unique<State>(path)) {}
RecordingReader::~RecordingReader() = default;
RecordingReader::RecordingReader(RecordingReader&&) noexcept = default;
RecordingReader& RecordingReader::operator=(RecordingReader&&) noexcept = default;

const LidarModel& RecordingReader::model() const { return state_->model; }
const Pose3& RecordingReader::T_vehicle_lidar() const { return state_->T_vehicle_lidar; }
std::size_t RecordingReader::sweeps() const { return state_->index.size(); }

Sweep RecordingReader::sweep(std::size_t i) const {
  const State& s = *state_;
  const auto [first, count] = s.returns_of(i);
  const auto range = s.range.read(first, count);
  const auto reflectivity = s.reflectivity.read(first, count);
  const auto laser = s.laser.read(first, count);
  const auto echo = s.echo.read(first, count);
  const auto time_offset_ns = s.time_offset_ns.read(first, count);
  Sweep sweep{s.index[i], s.start_time_s[i], s.start_azimuth_rad[i], {}};
  sweep.returns.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    if (laser[k] >= s.model.lasers.size()) fail_damaged(s.path, "an unknown laser in /returns");
    sweep.returns[k] = {time_offset_ns[k], range[k], laser[k], reflectivity[k], echo[k]};
  }
  return sweep;
}

std::vector<sim::ReturnTruth> RecordingReader::truth(std::size_t i) const {
  const auto [first, count] = state_->returns_of(i);
  const H5File& file = state_->file;
  const auto owner = file.open_column<std::int32_t>("/truth/returns/stem_id").read(first, count);
  const auto part = file.open_column<std::uint8_t>("/truth/returns/part").read(first, count);
  const auto range = file.open_column<float>("/truth/returns/range_m").read(first, count);
  std::vector<sim::ReturnTruth> truth(count);
  for (std::size_t k = 0; k < count; ++k) {
    if (part[k] >= sim::kPartCount) fail_damaged(state_->path, "an unknown part in /truth/returns");
    truth[k] = {{owner[k], static_cast<sim::Part>(part[k])}, range[k]};
  }
  return truth;
}

SweepKnots RecordingReader::poses(std::size_t i) const {
  HONKA_CHECK(i < sweeps(), "no such sweep");
  const H5File& file = state_->file;
  const auto first = file.open_column<std::uint64_t>("/truth/knots/first_knot").read(i, 2);
  if (first[1] < first[0]) fail_damaged(state_->path, "/truth/knots/first_knot");
  const std::uint64_t count = first[1] - first[0];
  SweepKnots knots;
  knots.times_s = file.open_column<double>("/truth/knots/time_s").read(first[0], count);
  const auto numbers = file.open_column<double>("/truth/knots/T_world_lidar").read(first[0], count);
  for (std::size_t k = 0; k < count; ++k) knots.T_world_lidar.push_back(pose_at(numbers, k));
  return knots;
}

StemTruth RecordingReader::stems() const {
  const H5File& file = state_->file;
  const auto all = [&](const std::string& name) {
    return file.open_column<double>("/truth/stems/" + name).read_all();
  };
  StemTruth truth;
  truth.ids = file.open_column<std::int32_t>("/truth/stems/id").read_all();
  const auto x = all("x_m"), y = all("y_m"), z = all("z_m");
  const auto dbh = all("dbh_m"), height = all("height_m");
  const auto seen = file.open_column<std::int64_t>("/truth/stems/observations").read_all();
  for (const std::size_t size :
       {x.size(), y.size(), z.size(), dbh.size(), height.size(), seen.size()}) {
    if (size != truth.ids.size()) fail_damaged(state_->path, "/truth/stems differ in length");
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    truth.stems_in_world.push_back({{x[i], y[i]},
                                    unless_nan(z[i]),
                                    unless_nan(dbh[i]),
                                    unless_nan(height[i]),
                                    static_cast<int>(seen[i])});
  }
  return truth;
}

std::map<std::string, std::string> RecordingReader::context() const {
  std::map<std::string, std::string> context;
  for (const std::string& name : state_->file.attributes("/context")) {
    context[name] = state_->file.string_attribute("/context", name);
  }
  return context;
}

}  // namespace honka::eval
