#include "eval/run/slam/link_exchange.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "eval/run/slam/link_quality.h"
#include "tests/eval/run/link_drive.h"

namespace honka::eval {
namespace {

LinkCase perfect_link() {
  LinkCase link{"loss", "independent", 0.0, {}, {}};
  link.radio.delay_s = 0.0;
  return link;
}

LinkOutcome over(const SlamDrive& drive, const LinkCase& link) {
  return exchange_drive(drive, drive.true_T_first_frame, link, 3);
}

}  // namespace

TEST_CASE("what a drive needs is counted from its frames") {
  const SlamDrive drive = straight_drive(40);
  const LinkNeed need = need_of(drive, 28, 55.296e-6);
  std::int64_t stems = 0;
  for (const SparseFrame& frame : drive.frames) {
    stems += static_cast<std::int64_t>(frame.points_m.size());
  }
  CHECK(need.key_frames == 40);
  CHECK(need.stems == stems);
  CHECK(need.message_bytes == 40 * 38.0 + 6.0 * static_cast<double>(stems));
  CHECK(need.air_bytes == need.message_bytes + 40 * 28.0);
  CHECK(need.length_m == drive.travelled_m.back());
  // VLP-16 manual: 754 packets a second.
  CHECK(need.raw_bytes / need.duration_s / 1206.0 == Approx(753.5).margin(0.1));
  CHECK(need.bytes_per_s() == need.air_bytes / drive.duration_s);
}

TEST_CASE("the links of the study vary one thing each") {
  LinkStudySettings settings;
  LinkNeed need;
  need.air_bytes = 5000.0;
  need.duration_s = 10.0;
  const auto cases = link_cases(settings, need);
  REQUIRE(cases.size() == 4 * 3 + 6 * 2 + 4);
  for (const LinkCase& link : cases) {
    const bool is_bandwidth = link.series == "bandwidth";
    CHECK(link.radio.bandwidth_bytes_per_s == (is_bandwidth ? link.value * 500.0 : 0.0));
    CHECK(link.radio.loss == (link.series == "loss" ? link.value : 0.0));
    CHECK(link.radio.delay_s == (link.series == "delay" ? link.value : settings.radio.delay_s));
  }
  CHECK(cases[0].edge.policy == "paced");
  CHECK(cases[1].edge.policy == "all");
  CHECK(cases[2].radio.queue_full == "drop_newest");
}

TEST_CASE("a perfect link gives the cloud every frame") {
  const SlamDrive drive = straight_drive(60);
  const LinkOutcome outcome = over(drive, perfect_link());
  CHECK(outcome.tally.arrived == 60);
  CHECK(outcome.tally.late == 0);
  CHECK(outcome.tally.behind_m == 0.0);
  CHECK(outcome.tally.age_p95_s == 0.0);
  const ReceivedFrames received = outcome.cloud.received();
  REQUIRE(received.frames().size() == 60);
  CHECK(received.gaps().empty());
  for (std::size_t i = 0; i < 60; ++i) {
    REQUIRE(received.frames()[i].number == drive.frames[i].number);
    REQUIRE(received.frames()[i].points_m.size() == drive.frames[i].points_m.size());
  }
}

TEST_CASE("a link that loses everything leaves the cloud with nothing") {
  LinkCase link = perfect_link();
  link.radio.loss = 1.0;
  const SlamDrive drive = straight_drive(20);
  const LinkOutcome outcome = over(drive, link);
  CHECK(outcome.tally.lost_on_air == 20);
  CHECK(outcome.cloud.received().empty());
  CHECK(std::isnan(outcome.tally.age_p50_s));
  CHECK(outcome.tally.behind_m > 0.0);
  SECTION("so does a drive without frames") {
    CHECK(over(SlamDrive{}, perfect_link()).cloud.received().empty());
  }
}

TEST_CASE("what is lost on a good link is lost on a worse one too") {
  const SlamDrive drive = straight_drive(100);
  LinkCase link = perfect_link();
  std::int64_t before = 101;
  for (const double loss : {0.0, 0.1, 0.3, 0.5}) {
    link.radio.loss = loss;
    const std::int64_t arrived = over(drive, link).tally.arrived;
    CHECK(arrived < before);
    before = arrived;
  }
}

TEST_CASE("a delay makes the end of the drive late and the map old") {
  const SlamDrive drive = straight_drive(101);  // a frame every 0.5 s and 0.5 m, 50 s
  LinkCase link = perfect_link();
  link.radio.delay_s = 20.25;
  const LinkTally tally = over(drive, link).tally;
  CHECK(tally.late == 41);
  CHECK(tally.arrived == 60);
  CHECK(tally.age_p50_s == Approx(20.25));
  // Nothing for 20.5 s, then 20.5 m behind.
  CHECK(tally.behind_m > 15.0);
  CHECK(tally.behind_m < 20.5);
}

TEST_CASE("a narrow link carries what it can") {
  const SlamDrive drive = straight_drive(200);
  const LinkNeed need = need_of(drive, 28, 55.296e-6);
  for (const LinkCase& link : link_cases(LinkStudySettings{}, need)) {
    if (link.series != "bandwidth") continue;
    const LinkTally tally = over(drive, link).tally;
    CAPTURE(link.value, link.variant);
    const double bandwidth = link.radio.bandwidth_bytes_per_s;
    CHECK(tally.edge.offered == 200);
    CHECK(tally.edge.sent + tally.edge.held_back == 200);
    // Until the end; what waits then is late.
    CHECK(static_cast<double>(tally.arrived) <= 1.0 + 1.2 * link.value * 200);
    if (link.variant == "paced") {
      CHECK(tally.queue_full == 0);
      CHECK(tally.age_p95_s <= 30.0 + 1200.0 / bandwidth + link.radio.delay_s);
    }
  }
}

TEST_CASE("the map at true poses has no error, a bent one has") {
  const SlamDrive drive = straight_drive(80);
  const StemMap3 stems = build_stem_map(drive.frames, drive.true_T_first_frame, {});
  const auto judge = [&](const FramePoses& poses) {
    return judge_link_map(drive, drive.frames, poses, stems.stems);
  };
  const LinkMapQuality floor = judge(drive.true_T_first_frame);
  CHECK(floor.ate_m < 1e-9);
  CHECK(floor.cluster_rmse_m < 1e-9);
  CHECK(floor.stems_mapped > 50);
  CHECK(floor.stems_false == 0);
  CHECK(floor.stem_rmse_m < 1e-6);

  FramePoses bent = drive.true_T_first_frame;
  for (std::size_t i = 40; i < bent.size(); ++i) bent[i].translation().y() += 1.0;
  const LinkMapQuality quality = judge(bent);
  CHECK(quality.ate_m > 0.1);
  CHECK(quality.ate_m < 1.0);
  CHECK(quality.blur > 1.3 * floor.blur);
}

TEST_CASE("a map of frames without stems, and of one frame, has no figures that are not") {
  SlamDrive drive = straight_drive(3);
  for (SparseFrame& frame : drive.frames) frame.points_m.clear();
  const LinkMapQuality nothing = judge_link_map(drive, drive.frames, drive.true_T_first_frame, {});
  CHECK(std::isnan(nothing.blur));
  CHECK(std::isnan(nothing.cluster_rmse_m));
  CHECK(nothing.stems_mapped == 0);
  const LinkMapQuality one =
      judge_link_map(drive, std::span(drive.frames).first(1), {Pose3::Identity()}, {});
  CHECK(std::isnan(one.ate_m));
}

}  // namespace honka::eval
