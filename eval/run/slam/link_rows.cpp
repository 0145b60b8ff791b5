#include "eval/run/slam/link_tables.h"

namespace honka::eval {

Table link_trial_table() {
  const std::vector<std::int64_t> integers;
  const std::vector<double> numbers;
  const std::vector<std::string> texts;
  return Table({
      {"trial", "", "trial (seed)", integers},
      {"series", "", "what about the link is varied", texts},
      {"variant", "", "policy of the edge, or pattern of the loss", texts},
      {"value", "", "share of the need, share lost, or delay in s", numbers},
      {"method", "", "of the cloud", texts},
      {"status", "", "mapped or nothing_received", texts},
      {"key_frames", "", "that the edge took", integers},
      {"sent", "", "messages given to the radio", integers},
      {"queue_full", "", "messages dropped by the queue", integers},
      {"lost_on_air", "", "messages lost on the air", integers},
      {"arrived", "", "messages until the drive's end", integers},
      {"late", "", "messages after it", integers},
      {"sent_bytes", "B", "payload given to the radio", integers},
      {"air_bytes", "B", "on the air, overhead included", numbers},
      {"age_p50_s", "s", "median age of what arrived", numbers},
      {"age_p95_s", "s", "95th percentile of it", numbers},
      {"behind_m", "m", "way since the newest frame that had arrived, mean", numbers},
      {"blur", "", "of the map", numbers},
      {"blur_floor", "", "of the same frames at true poses", numbers},
      {"cluster_rmse_m", "m", "mean over clusters, link 0.5 m", numbers},
      {"cluster_rmse_floor_m", "m", "of the same frames at true poses", numbers},
      {"ate_m", "m", "RMSE of positions after rigid alignment", numbers},
      {"ate_planar_m", "m", "of it x and y of truth", numbers},
      {"stems_mapped", "", "true stems in the map", integers},
      {"stems_mapped_floor", "", "of the same frames at true poses", integers},
      {"stems_false", "", "stems of the map without a true one", integers},
      {"stem_rmse_m", "m", "of the mapped stems", numbers},
      {"map_s", "s", "time of the method", numbers, false},
  });
}

void append_link_rows(Table& table, const LinkTrial& trial) {
  for (const LinkRow& row : trial.rows) {
    const LinkTally& t = row.tally;
    const LinkMapQuality &q = row.quality, &floor = row.floor;
    table.add_row(row.trial, row.link.series, row.link.variant, row.link.value, row.method,
                  row.status, t.edge.offered, t.edge.sent, t.queue_full + t.too_large,
                  t.lost_on_air, t.arrived, t.late, t.edge.bytes_sent, t.bytes_on_air, t.age_p50_s,
                  t.age_p95_s, t.behind_m, q.blur, floor.blur, q.cluster_rmse_m,
                  floor.cluster_rmse_m, q.ate_m, q.ate_planar_m, q.stems_mapped, floor.stems_mapped,
                  q.stems_false, q.stem_rmse_m, row.map_s);
  }
}

}  // namespace honka::eval
