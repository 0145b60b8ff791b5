#pragma once

#include <cstdint>
#include <filesystem>

#include "algo/types/stem.h"

namespace honka::eval {

/// A map has stems; a sensor may see none, and its list then is a header alone.
enum class StemList : std::uint8_t { kHasStems, kMayBeEmpty };

/// Whether each stem must have its z_m.
enum class StemHeights : std::uint8_t { kOptional, kNeeded };

/// Reads a list of stems: a header with x_m, y_m and any of z_m, dbh_m, height_m, observations, in
/// any order; other columns are ignored; '#' begins a comment line; optional cells may be empty.
/// Metres, in the frame of the list.
///
/// UserError "file:line:column: …" for a missing file, header or column, a cell that is no finite
/// number, a diameter or height that cannot be one, a row of another width, or a list without
/// stems, or a stem without z_m, where they are asked for.
[[nodiscard]] StemMap read_stem_csv(const std::filesystem::path& path,
                                    StemList list = StemList::kHasStems,
                                    StemHeights heights = StemHeights::kOptional);

/// Writes a list that read_stem_csv reads back bit for bit; optional columns where any stem has
/// them. Written safely; UserError when it cannot be.
void write_stem_csv(const std::filesystem::path& path, const StemMap& stems);

}  // namespace honka::eval
