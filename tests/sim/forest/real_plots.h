#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "algo/types/stem.h"

/// The measured Scots pine plots of Ilomantsi, where they are at hand.
namespace honka::testing {

struct Plot {
  std::string name;
  Eigen::AlignedBox2d window_m;
  StemMap stems;
};

inline StemMap read_plot(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  StemMap stems;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#' || line[0] == 'x') continue;
    std::vector<double> cells;
    std::stringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) {
      cells.push_back(cell.empty() || cell[0] == '\r' ? 0.0 : std::stod(cell));
    }
    Stem& stem = stems.emplace_back();
    stem.position_m = {cells[0], cells[1]};
    if (cells.size() > 2 && cells[2] > 0.0) stem.dbh_m = cells[2];
    if (cells.size() > 3 && cells[3] > 0.0) stem.height_m = cells[3];
  }
  return stems;
}

/// Empty where the data is absent.
inline std::vector<Plot> ilomantsi_plots() {
  struct Source {
    const char* file;
    double width_m, length_m;
  };
  constexpr std::array<Source, 6> kSources = {{{"ilomantsi_p05.csv", 40, 30},
                                               {"ilomantsi_p06.csv", 40, 40},
                                               {"ilomantsi_p13.csv", 50, 40},
                                               {"ilomantsi_p30.csv", 50, 30},
                                               {"ilomantsi_p33.csv", 60, 50},
                                               {"ilomantsi_p36.csv", 50, 40}}};
  const auto folder =
      std::filesystem::path(HONKA_SOURCE_DIR).parent_path() / "shared" / "data" / "stem_maps";
  std::vector<Plot> plots;
  for (const Source& source : kSources) {
    if (!std::filesystem::exists(folder / source.file)) continue;
    plots.push_back({source.file,
                     {Eigen::Vector2d::Zero(), Eigen::Vector2d(source.width_m, source.length_m)},
                     read_plot(folder / source.file)});
  }
  return plots;
}

}  // namespace honka::testing
