#include "eval/run/slam/link_cases.h"

namespace honka::eval {
namespace {

/// VLP-16 manual: a data packet has 1206 bytes of payload for 12 blocks of two firings.
constexpr double kPacketBytes = 1206.0;
constexpr double kFiringsPerPacket = 24.0;

void add_bandwidth_cases(const LinkStudySettings& settings, const LinkNeed& need,
                         std::vector<LinkCase>& cases) {
  for (const double share : settings.bandwidth_shares) {
    LinkCase link{"bandwidth", settings.edge.policy, share, settings.radio, settings.edge};
    link.radio.bandwidth_bytes_per_s = share * need.bytes_per_s();
    cases.push_back(link);
    if (settings.edge.policy == "all") continue;
    link.edge.policy = "all";
    for (const char* drops : {"drop_oldest", "drop_newest"}) {
      link.radio.queue_full = drops;
      link.variant = std::string("all, ") + drops;
      cases.push_back(link);
    }
  }
}

void add_loss_cases(const LinkStudySettings& settings, std::vector<LinkCase>& cases) {
  for (const double loss : settings.losses) {
    for (const char* pattern : {"independent", "bursts"}) {
      LinkCase link{"loss", pattern, loss, settings.radio, settings.edge};
      link.radio.loss = loss;
      link.radio.loss_pattern = pattern;
      cases.push_back(link);
    }
  }
}

void add_delay_cases(const LinkStudySettings& settings, std::vector<LinkCase>& cases) {
  for (const double delay_s : settings.delays_s) {
    LinkCase link{"delay", settings.edge.policy, delay_s, settings.radio, settings.edge};
    link.radio.delay_s = delay_s;
    cases.push_back(link);
  }
}

}  // namespace

LinkNeed need_of(const SlamDrive& drive, std::int64_t overhead_bytes, double firing_period_s) {
  LinkNeed need;
  need.duration_s = drive.duration_s;
  need.length_m = drive.travelled_m.empty() ? 0.0 : drive.travelled_m.back();
  need.raw_bytes = kPacketBytes * drive.duration_s / (kFiringsPerPacket * firing_period_s);
  for (const SparseFrame& frame : drive.frames) {
    const auto stems = static_cast<std::int64_t>(frame.points_m.size());
    ++need.key_frames;
    need.stems += stems;
    need.message_bytes += static_cast<double>(message_bytes(stems));
    need.air_bytes += static_cast<double>(message_bytes(stems) + overhead_bytes);
  }
  return need;
}

std::vector<LinkCase> link_cases(const LinkStudySettings& settings, const LinkNeed& need) {
  std::vector<LinkCase> cases;
  add_bandwidth_cases(settings, need, cases);
  add_loss_cases(settings, cases);
  add_delay_cases(settings, cases);
  return cases;
}

}  // namespace honka::eval
