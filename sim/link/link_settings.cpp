#include "sim/link/link_settings.h"

namespace honka::sim {

void describe(SettingsVisitor& v, LinkSettings& s) {
  v.field(
      {"bandwidth_bytes_per_s", "B/s", "of the radio, overhead included; 0 is unbounded", "choice"},
      s.bandwidth_bytes_per_s, Range{0.0, 1e12});
  v.field({"overhead_bytes", "B", "that the network adds to each message",
           "UDP (RFC 768) over IPv4 (RFC 791)"},
          s.overhead_bytes, Range{0.0, 1e6});
  v.field({"loss", "", "share of messages lost on the air", "choice"}, s.loss, Range{0.0, 1.0});
  v.field({"loss_pattern", "", "each message for itself, or in bad spells",
           "Gilbert 1960, Elliott 1963; no loss in the good state"},
          s.loss_pattern, {"independent", "bursts"});
  v.field({"burst_s", "s", "mean length of a bad spell", "choice"}, s.burst_s, Range{1e-3, 1e6});
  v.field({"burst_loss", "", "share of messages lost in a bad spell; at least link.loss", "choice"},
          s.burst_loss, Range{1e-6, 1.0});
  v.field({"delay_s", "s", "between air and cloud, fixed part", "choice"}, s.delay_s,
          Range{0.0, 60.0});
  v.field({"jitter_s", "s", "on top, uniform from 0; may change the order", "choice"}, s.jitter_s,
          Range{0.0, 60.0});
  v.field(
      {"queue_bytes", "B", "that the edge holds back, overhead included; 0 is unbounded", "choice"},
      s.queue_bytes, Range{0.0, 1e15});
  v.field({"queue_full", "", "which messages a full queue drops", "choice"}, s.queue_full,
          {"drop_oldest", "drop_newest"});
}

}  // namespace honka::sim
