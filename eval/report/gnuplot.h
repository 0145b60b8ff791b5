#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// The one door to gnuplot: a figure as NAME.dat and NAME.gp in a folder, drawn as NAME.svg or
/// NAME.png. `gnuplot NAME.gp` inside the folder draws it again.
class Figure {
 public:
  enum class Format { kSvg, kPng };  ///< PNG for many thousand points

  Figure(std::filesystem::path folder, std::string name, int width_px, int height_px,
         Format format = Format::kSvg);

  /// Adds a block of rows to NAME.dat; returns the text that names it in a plot command. Columns
  /// are of equal length; NaN is a gap. `what` becomes a comment.
  [[nodiscard]] std::string data(const std::string& what,
                                 const std::vector<std::vector<double>>& columns);
  [[nodiscard]] std::string data(const std::string& what,
                                 const std::vector<Eigen::Vector2d>& points);
  /// Polylines as one block: a blank line between them lifts the pen.
  [[nodiscard]] std::string lines(const std::string& what,
                                  const std::vector<std::vector<Eigen::Vector2d>>& polylines);

  /// Adds a line to NAME.gp.
  Figure& operator<<(const std::string& line);
  /// Sets the title, with the protocol in smaller print below.
  Figure& title(const std::string& title, const std::string& protocol);
  /// Puts the legend below the plot, which ends so many pixels above the picture's edge.
  Figure& key_below(int margin_px);
  /// Adds one plot command of several elements.
  Figure& plot(const std::vector<std::string>& elements);

  /// Writes both files and runs gnuplot. Where gnuplot is missing the result carries a notice with
  /// the remedy in place of a file. RunError with gnuplot's own line when it refuses the script.
  [[nodiscard]] ReportFigure draw(const std::string& report_title, const std::string& caption);

 private:
  std::filesystem::path folder_;
  std::string name_, extension_, data_, script_, title_;
  int height_px_ = 0, blocks_ = 0;
  bool empty_ = true;
};

/// A text as a quoted gnuplot string in which nothing is markup.
[[nodiscard]] std::string gnuplot_text(const std::string& text);

/// A number for a script.
[[nodiscard]] std::string number(double value);

/// Okabe and Ito's colours, told apart by the colour-blind too.
inline constexpr const char* kBlack = "'#000000'";
inline constexpr const char* kOrange = "'#E69F00'";
inline constexpr const char* kSky = "'#56B4E9'";
inline constexpr const char* kGreen = "'#009E73'";
inline constexpr const char* kYellow = "'#F0E442'";
inline constexpr const char* kBlue = "'#0072B2'";
inline constexpr const char* kRed = "'#D55E00'";
inline constexpr const char* kPink = "'#CC79A7'";
/// Dark violet over green to yellow: even in lightness, for heights.
inline constexpr const char* kHeightPalette =
    "set palette defined (0 '#440154', 1 '#414487', 2 '#2A788E', 3 '#22A884', 4 '#7AD151', "
    "5 '#FDE725')";
inline constexpr const char* kGrey = "'#8A8A8A'";

/// The colour and point type of the i-th series (C1, C3, C5, C10 …), the same in all figures.
[[nodiscard]] std::string series_colour(std::size_t i);
[[nodiscard]] std::string series_point(std::size_t i);

/// "C10" for windows of 10 key frames.
[[nodiscard]] std::string frames_label(std::int64_t frames);

}  // namespace honka::eval
