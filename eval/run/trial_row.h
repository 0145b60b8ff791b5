#pragma once

#include "eval/config/scenario.h"
#include "eval/io/table.h"
#include "eval/run/localization_trial.h"

namespace honka::eval {

/// The empty table of /trials; its columns are the schema.
[[nodiscard]] Table trial_table();

/// Appends what a trial's world, scans and maps were like; NaN where a map was not asked for.
void append_trial(Table& table, std::int64_t trial, const TrialExhibit& exhibit,
                  const Scenario& scenario);

}  // namespace honka::eval
