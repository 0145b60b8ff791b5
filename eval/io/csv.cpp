#include "eval/io/csv.h"

#include <algorithm>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"
#include "eval/io/text_table.h"

namespace honka::eval {
namespace {

using Path = std::filesystem::path;

bool looks_like_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("+-0123456789.eE") == std::string::npos &&
         text.find_first_of("0123456789") != std::string::npos;
}

void check_is_header(const Path& path, const CellRow& header) {
  if (std::all_of(header.begin(), header.end(),
                  [](const Cell& cell) { return looks_like_number(cell.text); })) {
    throw_at(path, header.front(), "no header; add a first line that names the columns: x_m,y_m");
  }
}

/// Position of a column in the header, if it is there.
std::optional<std::size_t> find_column(const Path& path, const CellRow& header,
                                       const std::string& name) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i].text != name) continue;
    if (found) throw_at(path, header[i], "column '" + name + "' a second time; take one out");
    found = i;
  }
  return found;
}

[[noreturn]] void throw_missing(const Path& path, const CellRow& header, const std::string& name,
                                const std::string& remedy) {
  const std::string what = "no column '" + name + "'";
  if (header.size() == 1 && header[0].text.find_first_of(";\t") != std::string::npos) {
    throw_at(path, header.front(), what + "; separate the columns by commas");
  }
  std::vector<std::string> names;
  for (const Cell& cell : header) {
    if (cell.text != "x_m" && cell.text != "y_m") names.push_back(cell.text);
  }
  const auto nearest = did_you_mean(name, names);
  if (nearest) {
    const auto cell = std::find_if(header.begin(), header.end(),
                                   [&](const Cell& c) { return c.text == *nearest; });
    throw_at(path, *cell, what + "; did you mean '" + name + "' by '" + *nearest + "'?");
  }
  throw_at(path, header.front(), what + "; " + remedy);
}

std::size_t require_column(const Path& path, const CellRow& header, const std::string& name,
                           const std::string& remedy) {
  const auto found = find_column(path, header, name);
  if (!found) throw_missing(path, header, name, remedy);
  return *found;
}

constexpr const char* kNeedsPlaces = "a stem list needs the columns x_m and y_m";
constexpr const char* kNeedsHeights = "stems in space need the height of each foot in metres";

/// The optional number of a row, empty when the column or the cell is.
std::optional<double> optional_number(const Path& path, const CellRow& row,
                                      std::optional<std::size_t> column, const std::string& name) {
  if (!column || row[*column].text.empty()) return std::nullopt;
  return number_in(path, row[*column], name);
}

/// As above, and within (0, high]: what lies outside is in another unit than metres.
std::optional<double> size_in_metres(const Path& path, const CellRow& row,
                                     std::optional<std::size_t> column, const std::string& name,
                                     double high) {
  const auto value = optional_number(path, row, column, name);
  if (value && !(*value > 0.0 && *value <= high)) {
    throw_at(path, row[*column],
             "column '" + name + "': " + row[*column].text + " is outside 0 to " +
                 exact_text(high) + " m; give metres, or leave the cell empty if not known");
  }
  return value;
}

struct StemColumns {
  StemColumns(const Path& path, const CellRow& header, StemHeights heights)
      : x(require_column(path, header, "x_m", kNeedsPlaces)),
        y(require_column(path, header, "y_m", kNeedsPlaces)),
        z(heights == StemHeights::kNeeded ? require_column(path, header, "z_m", kNeedsHeights)
                                          : find_column(path, header, "z_m")),
        dbh(find_column(path, header, "dbh_m")),
        height(find_column(path, header, "height_m")),
        observations(find_column(path, header, "observations")) {}
  std::size_t x, y;
  std::optional<std::size_t> z, dbh, height, observations;
};

Stem stem_in(const Path& path, const CellRow& row, const StemColumns& columns) {
  // The thickest tree known has 11.6 m, the tallest 116 m.
  constexpr double kMaxDbh_m = 12.0, kMaxHeight_m = 120.0;
  Stem stem;
  stem.position_m = {number_in(path, row[columns.x], "x_m"),
                     number_in(path, row[columns.y], "y_m")};
  stem.z_m = optional_number(path, row, columns.z, "z_m");
  stem.dbh_m = size_in_metres(path, row, columns.dbh, "dbh_m", kMaxDbh_m);
  stem.height_m = size_in_metres(path, row, columns.height, "height_m", kMaxHeight_m);
  const auto seen = optional_number(path, row, columns.observations, "observations");
  stem.observations = static_cast<int>(std::clamp(seen.value_or(0.0), 0.0, 2e9));
  return stem;
}

std::string optional_cell(const std::optional<double>& value) {
  return std::string(",").append(value ? exact_text(*value) : "");
}

}  // namespace

StemMap read_stem_csv(const Path& path, StemList list, StemHeights heights) {
  const auto rows = split_rows(read_text_file(path), Separator::kComma);
  if (rows.empty()) {
    throw UserError(path.string() + ": empty; give a header x_m,y_m and a row for each stem");
  }
  const CellRow& header = rows.front();
  check_is_header(path, header);
  const StemColumns columns(path, header, heights);
  StemMap stems;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].size() != header.size()) {
      throw_at(path, rows[i].front(),
               std::to_string(rows[i].size()) + " cells where the header has " +
                   std::to_string(header.size()) + "; add or take out commas");
    }
    stems.push_back(stem_in(path, rows[i], columns));
    if (heights == StemHeights::kNeeded && !stems.back().z_m) {
      throw_at(path, rows[i][*columns.z], std::string("column 'z_m' is empty; ") + kNeedsHeights);
    }
  }
  if (stems.empty() && list == StemList::kHasStems) {
    throw_at(path, header.front(), "a header and no stems; give a row for each stem");
  }
  return stems;
}

void write_stem_csv(const Path& path, const StemMap& stems) {
  const auto any = [&](auto has) { return std::any_of(stems.begin(), stems.end(), has); };
  const bool z = any([](const Stem& s) { return s.z_m.has_value(); });
  const bool dbh = any([](const Stem& s) { return s.dbh_m.has_value(); });
  const bool height = any([](const Stem& s) { return s.height_m.has_value(); });
  const bool observations = any([](const Stem& s) { return s.observations != 0; });
  std::string text = "x_m,y_m";
  text += z ? ",z_m" : "";
  text += dbh ? ",dbh_m" : "";
  text += height ? ",height_m" : "";
  text += observations ? ",observations\n" : "\n";
  for (const Stem& stem : stems) {
    text += exact_text(stem.position_m.x()) + ',' + exact_text(stem.position_m.y());
    if (z) text += optional_cell(stem.z_m);
    if (dbh) text += optional_cell(stem.dbh_m);
    if (height) text += optional_cell(stem.height_m);
    if (observations) text.append(",").append(std::to_string(stem.observations));
    text += "\n";
  }
  write_file_safely(path, text);
}

}  // namespace honka::eval
