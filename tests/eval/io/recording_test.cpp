#include "eval/io/recording.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <cmath>
#include <csignal>

#include "algo/types/random.h"
#include "eval/io/hdf5.h"
#include "eval/io/safe_file.h"
#include "tests/eval/io/synthetic_sweep.h"
#include "tests/eval/io/temporary_folder.h"

using namespace honka;
using namespace honka::eval;
using honka::test::synthetic_sweep;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

namespace {

StemTruth some_stems() {
  StemTruth truth;
  truth.stems_in_world = {{{1.0 / 3.0, 7012345.678}, 0.5, 0.31, 21.0, 4},
                          {{-2.0, 5.0}, {}, {}, {}, 0}};
  truth.ids = {17, 2000};
  return truth;
}

SweepKnots some_knots(int sweep) {
  SweepKnots knots;
  for (int k = 0; k < 3; ++k) {
    const double t = 0.1 * sweep + 0.05 * k;
    knots.times_s.push_back(t);
    knots.T_world_lidar.push_back(pose_from_rpy({t, 1.0 / 7.0, 3.5}, 0.01 * t, 0.02, t));
  }
  return knots;
}

const Pose3 kMounting = pose_from_rpy({1.2, 0.0, 2.8}, 0.0, 0.05, 0.0);

void write_some(const std::filesystem::path& path, int sweeps) {
  RecordingWriter writer(path, vlp16(10.0, true), kMounting, some_stems(), {{"commit", "abc"}});
  for (int i = 0; i < sweeps; ++i) {
    const SweepKnots knots = some_knots(i);
    writer.append(synthetic_sweep(i), knots.T_world_lidar, knots.times_s);
  }
  writer.commit();
}

}  // namespace

TEST_CASE("recording: goes round bit for bit over several chunks") {
  const TemporaryFolder folder;
  constexpr int kSweeps = 10;
  write_some(folder / "r.h5", kSweeps);
  const RecordingReader reader(folder / "r.h5");
  CHECK(reader.model().name == "vlp16");
  CHECK(reader.model().lasers[3].elevation_rad == vlp16().lasers[3].elevation_rad);
  CHECK(reader.model().lasers[3].vertical_offset_m ==
        vlp16(10.0, true).lasers[3].vertical_offset_m);
  CHECK(reader.model().range_resolution_m == 0.002);
  CHECK(reader.T_vehicle_lidar().matrix() == kMounting.matrix());
  CHECK(reader.stems() == some_stems());
  CHECK(reader.context().at("commit") == "abc");
  REQUIRE(reader.sweeps() == kSweeps);
  for (const int i : {9, 0, 1, 2, 3, 4, 5, 6, 7, 8}) {
    const sim::TruthfulSweep expected = synthetic_sweep(i);
    const Sweep sweep = reader.sweep(static_cast<std::size_t>(i));
    CHECK(sweep.index == expected.sweep.index);
    CHECK(sweep.start_time_s == expected.sweep.start_time_s);
    CHECK(sweep.start_azimuth_rad == expected.sweep.start_azimuth_rad);
    CHECK((sweep.returns == expected.sweep.returns));
    const auto truth = reader.truth(static_cast<std::size_t>(i));
    REQUIRE(truth.size() == expected.truth.size());
    bool equal = true;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      equal = equal && truth[k].label == expected.truth[k].label &&
              truth[k].range_m == expected.truth[k].range_m;
    }
    CHECK(equal);
    const SweepKnots knots = reader.poses(static_cast<std::size_t>(i));
    CHECK(knots.times_s == some_knots(i).times_s);
    REQUIRE(knots.T_world_lidar.size() == 3);
    CHECK(knots.T_world_lidar[2].matrix() == some_knots(i).T_world_lidar[2].matrix());
  }
}

TEST_CASE("recording: empty recordings and empty sweeps are recordings") {
  const TemporaryFolder folder;
  {
    RecordingWriter writer(folder / "r.h5", vlp16(), Pose3::Identity(), {});
    writer.append({{5, 1.0, 0.5, {}}, {}}, {}, {});
    writer.commit();
  }
  const RecordingReader reader(folder / "r.h5");
  REQUIRE(reader.sweeps() == 1);
  CHECK(reader.sweep(0).index == 5);
  CHECK(reader.sweep(0).returns.empty());
  CHECK(reader.poses(0).times_s.empty());
  CHECK(reader.stems().ids.empty());
  write_some(folder / "none.h5", 0);
  CHECK(RecordingReader(folder / "none.h5").sweeps() == 0);
}

TEST_CASE("recording: without a commit, thrown away or killed, no file shows") {
  const TemporaryFolder folder;
  {
    RecordingWriter writer(folder / "r.h5", vlp16(), Pose3::Identity(), {});
    writer.append(synthetic_sweep(0), {}, {});
  }
  CHECK(folder.entries() == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    RecordingWriter writer(folder / "r.h5", vlp16(), Pose3::Identity(), {});
    for (int i = 0; i < 9; ++i) writer.append(synthetic_sweep(i), {}, {});
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  CHECK_FALSE(std::filesystem::exists(folder / "r.h5"));
}

TEST_CASE("recording: truncated, foreign and newer files give one line") {
  const TemporaryFolder folder;
  const auto line = [&](const std::string& name) {
    const std::string text = user_error_of([&] { RecordingReader reader(folder / name); });
    CHECK(text.find('\n') == std::string::npos);
    CHECK(text.find(name) != std::string::npos);
    return text;
  };
  write_some(folder / "whole.h5", 2);
  const std::string bytes = read_text_file(folder / "whole.h5");
  write_raw(folder / "cut.h5", bytes.substr(0, bytes.size() / 2));
  CHECK(line("cut.h5").find("truncated") != std::string::npos);
  write_raw(folder / "text.h5", "not HDF5");
  CHECK(line("text.h5").find("not an HDF5 file") != std::string::npos);
  {
    H5File foreign = H5File::create(folder / "foreign.h5");
    foreign.write<double>("/x", std::vector<double>{1.0});
    foreign.close();
    H5File newer = H5File::create(folder / "newer.h5");
    newer.set_attribute("/", "format", std::string("honka recording"));
    newer.set_attribute("/", "schema_version", kRecordingSchemaVersion + 1);
    newer.close();
    H5File hollow = H5File::create(folder / "hollow.h5");
    hollow.set_attribute("/", "format", std::string("honka recording"));
    hollow.set_attribute("/", "schema_version", kRecordingSchemaVersion);
    hollow.close();
  }
  CHECK(line("foreign.h5").find("not a honka recording") != std::string::npos);
  CHECK(line("newer.h5").find("use a newer honka") != std::string::npos);
  CHECK(line("hollow.h5").find("damaged") != std::string::npos);
  CHECK(line("none.h5").find("no such file") != std::string::npos);
}

TEST_CASE("recording: a disk that fills up gives one line and leaves no file") {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1 << 20, 1 << 20};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_some(folder / "r.h5", 30);
    } catch (const UserError& error) {
      ::_exit(std::string(error.what()).find("cannot be written") != std::string::npos ? 2 : 1);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 2);
  CHECK(folder.entries() == 0);
}
