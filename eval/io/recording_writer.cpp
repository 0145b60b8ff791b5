#include <limits>
#include <optional>

#include "algo/types/check.h"
#include "eval/io/hdf5.h"
#include "eval/io/recording.h"
#include "eval/io/safe_file.h"

namespace honka::eval {
namespace {

// Chunks of 2^17 rows: 0.1–0.5 MB, inside HDF5's cache; about eight sweeps of 17,000 returns.
constexpr std::uint64_t kChunkReturns = 1 << 17;
constexpr std::uint64_t kChunkSweeps = 1 << 10;
constexpr std::uint64_t kPoseNumbers = 12;

/// A column filled in memory and written in whole chunks.
template <class T>
class BufferedColumn {
 public:
  BufferedColumn(H5File& file, const std::string& name, H5Layout layout, std::uint64_t width = 1)
      : column_(file.create_column<T>(name, width, layout)), limit_(layout.chunk_rows * width) {
    buffer_.reserve(limit_);
  }
  void push(T value) {
    buffer_.push_back(value);
    if (buffer_.size() == limit_) flush();
  }
  /// Appends `count` values made by `value_at(i)`, chunk by chunk.
  template <class ValueAt>
  void push_all(std::size_t count, ValueAt value_at) {
    for (std::size_t i = 0; i < count;) {
      const std::size_t end = std::min(count, i + limit_ - buffer_.size());
      for (; i < end; ++i) buffer_.push_back(value_at(i));
      if (buffer_.size() == limit_) flush();
    }
  }
  void flush() {
    column_.append(buffer_);
    buffer_.clear();
  }

 private:
  H5Column<T> column_;
  std::size_t limit_;
  std::vector<T> buffer_;
};

constexpr H5Layout deflated(std::uint64_t chunk_rows) { return {chunk_rows, 1}; }
// Deflate costs more time than it saves space on the near-random columns: see the README.
constexpr H5Layout plain(std::uint64_t chunk_rows) { return {chunk_rows, 0}; }

double or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::array<double, kPoseNumbers> pose_numbers(const Pose3& pose) {
  std::array<double, kPoseNumbers> numbers{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      numbers[static_cast<std::size_t>(4 * row + column)] = pose.matrix()(row, column);
    }
  }
  return numbers;
}

void write_sensor(H5File& file, const LidarModel& model, const Pose3& T_vehicle_lidar) {
  file.create_group("/sensor");
  file.set_attribute("/sensor", "name", model.name);
  file.set_attribute("/sensor", "firing_period_s", model.firing_period_s);
  file.set_attribute("/sensor", "rotation_rate_hz", model.rotation_rate_hz);
  file.set_attribute("/sensor", "range_resolution_m", model.range_resolution_m);
  file.set_attribute("/sensor", "max_range_m", model.max_range_m);
  std::vector<double> elevation, vertical_offset, firing_offset;
  for (const Laser& laser : model.lasers) {
    elevation.push_back(laser.elevation_rad);
    vertical_offset.push_back(laser.vertical_offset_m);
    firing_offset.push_back(laser.firing_offset_s);
  }
  file.write<double>("/sensor/elevation_rad", elevation);
  file.write<double>("/sensor/vertical_offset_m", vertical_offset);
  file.write<double>("/sensor/firing_offset_s", firing_offset);
  file.write<double>("/sensor/T_vehicle_lidar", pose_numbers(T_vehicle_lidar), kPoseNumbers);
}

void write_stems(H5File& file, const StemTruth& truth) {
  HONKA_CHECK(truth.stems_in_world.size() == truth.ids.size(), "one id a stem");
  std::vector<double> x, y, z, dbh, height;
  std::vector<std::int64_t> observations;
  for (const Stem& stem : truth.stems_in_world) {
    x.push_back(stem.position_m.x());
    y.push_back(stem.position_m.y());
    z.push_back(or_nan(stem.z_m));
    dbh.push_back(or_nan(stem.dbh_m));
    height.push_back(or_nan(stem.height_m));
    observations.push_back(stem.observations);
  }
  file.create_group("/truth/stems");
  file.write<std::int32_t>("/truth/stems/id", truth.ids);
  file.write<double>("/truth/stems/x_m", x);
  file.write<double>("/truth/stems/y_m", y);
  file.write<double>("/truth/stems/z_m", z);
  file.write<double>("/truth/stems/dbh_m", dbh);
  file.write<double>("/truth/stems/height_m", height);
  file.write<std::int64_t>("/truth/stems/observations", observations);
}

H5File open_for_sweeps(const std::filesystem::path& path, const LidarModel& model,
                       const Pose3& T_vehicle_lidar, const StemTruth& stems,
                       const std::map<std::string, std::string>& context) {
  H5File file = H5File::create(path);
  file.set_attribute("/", "format", std::string("honka recording"));
  file.set_attribute("/", "schema_version", kRecordingSchemaVersion);
  file.create_group("/context");
  for (const auto& [key, value] : context) file.set_attribute("/context", key, value);
  write_sensor(file, model, T_vehicle_lidar);
  file.create_group("/sweeps");
  file.create_group("/returns");
  file.create_group("/truth");
  write_stems(file, stems);
  file.create_group("/truth/knots");
  file.create_group("/truth/returns");
  return file;
}

/// Every column that grows with the sweeps.
struct Columns {
  explicit Columns(H5File& f)
      : index(f, "/sweeps/index", deflated(kChunkSweeps)),
        start_time_s(f, "/sweeps/start_time_s", deflated(kChunkSweeps)),
        start_azimuth_rad(f, "/sweeps/start_azimuth_rad", deflated(kChunkSweeps)),
        first_return(f, "/sweeps/first_return", deflated(kChunkSweeps)),
        range(f, "/returns/range_ticks", plain(kChunkReturns)),
        reflectivity(f, "/returns/reflectivity", plain(kChunkReturns)),
        laser(f, "/returns/laser", deflated(kChunkReturns)),
        echo(f, "/returns/echo", deflated(kChunkReturns)),
        time_offset_ns(f, "/returns/time_offset_ns", plain(kChunkReturns)),
        stem_id(f, "/truth/returns/stem_id", deflated(kChunkReturns)),
        part(f, "/truth/returns/part", deflated(kChunkReturns)),
        true_range_m(f, "/truth/returns/range_m", plain(kChunkReturns)),
        first_knot(f, "/truth/knots/first_knot", deflated(kChunkSweeps)),
        knot_time_s(f, "/truth/knots/time_s", deflated(kChunkSweeps)),
        pose(f, "/truth/knots/T_world_lidar", deflated(kChunkSweeps), kPoseNumbers) {}

  void add_returns(const sim::TruthfulSweep& s) {
    const auto& r = s.sweep.returns;
    const auto& t = s.truth;
    range.push_all(r.size(), [&](std::size_t i) { return r[i].range_ticks; });
    reflectivity.push_all(r.size(), [&](std::size_t i) { return r[i].reflectivity; });
    laser.push_all(r.size(), [&](std::size_t i) { return r[i].laser; });
    echo.push_all(r.size(), [&](std::size_t i) { return r[i].echo; });
    time_offset_ns.push_all(r.size(), [&](std::size_t i) { return r[i].time_offset_ns; });
    stem_id.push_all(t.size(), [&](std::size_t i) { return t[i].label.owner; });
    part.push_all(t.size(), [&](std::size_t i) { return std::uint8_t(t[i].label.part); });
    true_range_m.push_all(t.size(), [&](std::size_t i) { return t[i].range_m; });
  }

  void flush() {
    std::apply(
        [](auto&... column) { (column.flush(), ...); },
        std::tie(index, start_time_s, start_azimuth_rad, first_return, range, reflectivity, laser,
                 echo, time_offset_ns, stem_id, part, true_range_m, first_knot, knot_time_s, pose));
  }

  BufferedColumn<std::int64_t> index;
  BufferedColumn<double> start_time_s, start_azimuth_rad;
  BufferedColumn<std::uint64_t> first_return;
  BufferedColumn<std::uint16_t> range;
  BufferedColumn<std::uint8_t> reflectivity, laser, echo;
  BufferedColumn<std::uint32_t> time_offset_ns;
  BufferedColumn<std::int32_t> stem_id;
  BufferedColumn<std::uint8_t> part;
  BufferedColumn<float> true_range_m;
  BufferedColumn<std::uint64_t> first_knot;
  BufferedColumn<double> knot_time_s, pose;
};

}  // namespace

struct RecordingWriter::State {
  StagedFile staged;
  H5File file;
  std::optional<Columns> columns;
  std::uint64_t returns = 0, knots = 0;
};

RecordingWriter::RecordingWriter(const std::filesystem::path& path, const LidarModel& model,
                                 const Pose3& T_vehicle_lidar, const StemTruth& stems,
                                 const std::map<std::string, std::string>& context)
    : state_(new State{StagedFile(path), {}, {}}) {
  state_->file =
      open_for_sweeps(state_->staged.temporary(), model, T_vehicle_lidar, stems, context);
  state_->columns.emplace(state_->file);
  state_->columns->first_return.push(0);
  state_->columns->first_knot.push(0);
}

RecordingWriter::~RecordingWriter() = default;
RecordingWriter::RecordingWriter(RecordingWriter&&) noexcept = default;
RecordingWriter& RecordingWriter::operator=(RecordingWriter&&) noexcept = default;

void RecordingWriter::append(const sim::TruthfulSweep& sweep,
                             const std::vector<Pose3>& T_world_lidar_at_knots,
                             const std::vector<double>& knot_times_s) {
  HONKA_CHECK(sweep.truth.size() == sweep.sweep.returns.size(), "one truth a return");
  HONKA_CHECK(T_world_lidar_at_knots.size() == knot_times_s.size(), "one time a knot");
  HONKA_CHECK(state_->columns.has_value(), "append after commit");
  Columns& columns = *state_->columns;
  columns.add_returns(sweep);
  for (std::size_t k = 0; k < knot_times_s.size(); ++k) {
    columns.knot_time_s.push(knot_times_s[k]);
    for (const double number : pose_numbers(T_world_lidar_at_knots[k])) columns.pose.push(number);
  }
  state_->returns += sweep.truth.size();
  state_->knots += knot_times_s.size();
  columns.index.push(sweep.sweep.index);
  columns.start_time_s.push(sweep.sweep.start_time_s);
  columns.start_azimuth_rad.push(sweep.sweep.start_azimuth_rad);
  columns.first_return.push(state_->returns);
  columns.first_knot.push(state_->knots);
}

void RecordingWriter::commit() {
  HONKA_CHECK(state_->columns.has_value(), "commit twice");
  state_->columns->flush();
  state_->columns.reset();
  state_->file.close();
  state_->staged.commit();
}

}  // namespace honka::eval
