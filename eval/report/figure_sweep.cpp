#include "eval/report/figure_sweep.h"

#include <algorithm>
#include <cmath>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

/// Numbers and their span, as the axis shows them.
struct SweepScale {
  std::vector<double> numbers;  ///< rising, each once
  bool log = false;
  double low = 0.0, high = 1.0;  ///< of the axis

  /// A place moved by a share of the span, so that the intervals of curves do not hide each other.
  [[nodiscard]] double moved(double x, double share) const {
    return log ? x * std::pow(high / low, share) : x + share * (high - low);
  }
};

SweepScale scale_of(const SweepAxis& axis) {
  constexpr double kLogFrom = 20.0, kMargin = 0.06;
  SweepScale scale;
  scale.numbers = axis.numbers;
  for (std::size_t k = 0; k < axis.words.size(); ++k) scale.numbers.push_back(double(k));
  std::sort(scale.numbers.begin(), scale.numbers.end());
  scale.numbers.erase(std::unique(scale.numbers.begin(), scale.numbers.end()), scale.numbers.end());
  if (scale.numbers.empty()) return scale;
  const double first = scale.numbers.front(), last = scale.numbers.back();
  if (!axis.words.empty() || first == last) {
    const double room = axis.words.empty() && first != 0.0 ? 0.5 * std::abs(first) : 0.5;
    scale.low = first - room;
    scale.high = last + room;
    return scale;
  }
  scale.log = first > 0.0 && last / first >= kLogFrom;
  scale.low =
      scale.log ? first * std::pow(last / first, -kMargin) : first - kMargin * (last - first);
  scale.high = scale.log ? last * std::pow(last / first, kMargin) : last + kMargin * (last - first);
  return scale;
}

/// gnuplot reads a tic's label as a format: a percent sign stands twice.
std::string sweep_tic(const std::string& label) {
  std::string text;
  for (const char c : label) text += c == '%' ? "%%" : std::string(1, c);
  return gnuplot_text(text);
}

/// Words that would run into each other side by side.
bool has_long_words(const SweepAxis& axis) {
  return std::any_of(axis.words.begin(), axis.words.end(),
                     [](const std::string& word) { return word.size() > 14; });
}

/// At the values themselves where they are few; those that would overlap have no label.
std::string tics_of(const SweepAxis& axis, const SweepScale& scale) {
  constexpr std::size_t kFew = 12;
  constexpr double kRoom = 0.065;
  if (axis.words.empty() && scale.numbers.size() > kFew) return "set xtics auto";
  std::string tics;
  double last = -1.0;
  for (const double number : scale.numbers) {
    const double place = scale.log ? std::log(number / scale.low) / std::log(scale.high / scale.low)
                                   : (number - scale.low) / (scale.high - scale.low);
    if (axis.words.empty() && last >= 0.0 && place - last < kRoom) continue;
    last = place;
    const std::string label =
        axis.words.empty() ? eval::number(number) : axis.words[static_cast<std::size_t>(number)];
    tics += (tics.empty() ? "" : ", ") + sweep_tic(label) + " " + eval::number(number);
  }
  return "set xtics " + std::string(has_long_words(axis) ? "rotate by -20 " : "") + "(" + tics +
         ")";
}

/// Columns x, middle, low, high, without points that have no value, or none that has a logarithm.
std::vector<std::vector<double>> sweep_columns(const SweepCurve& curve, const SweepScale& scale,
                                               double share, bool log_y) {
  std::vector<std::vector<double>> columns(4);
  const auto shown = [log_y](double y) { return std::isfinite(y) && (!log_y || y > 0.0); };
  for (const SweepPoint& point : curve.points) {
    if (!shown(point.middle)) continue;
    const bool ends = shown(point.low) && shown(point.high);
    columns[0].push_back(scale.moved(point.x, share));
    columns[1].push_back(point.middle);
    columns[2].push_back(ends ? point.low : point.middle);
    columns[3].push_back(ends ? point.high : point.middle);
  }
  return columns;
}

std::string title_of(const SweepCurve& curve) {
  return curve.label.empty() ? " notitle" : " title " + gnuplot_text(curve.label);
}

std::vector<std::string> panel_elements(Figure& figure, const SweepPanel& panel,
                                        const SweepScale& scale, bool log_y) {
  constexpr double kStep = 0.011;
  std::vector<std::string> elements;
  const double middle = 0.5 * (static_cast<double>(panel.curves.size()) - 1.0);
  for (std::size_t k = 0; k < panel.curves.size(); ++k) {
    const SweepCurve& curve = panel.curves[k];
    const double share = curve.reference ? 0.0 : kStep * (static_cast<double>(k) - middle);
    const auto columns = sweep_columns(curve, scale, share, log_y);
    if (columns.front().empty()) continue;  // gnuplot refuses a block without a number
    const std::string block =
        figure.data(panel.title + " " + curve.label + ": x, value, low, high", columns);
    const std::string style = " lc " + series_colour(curve.style);
    if (curve.reference) {
      elements.push_back(block + " using 1:2 with lines dt 2 lw 1.6" + style + title_of(curve));
      continue;
    }
    elements.push_back(block + " using 1:2 with lines lw 1.1" + style + " notitle");
    elements.push_back(block + " using 1:2:3:4 with yerrorbars lw 1.8 ps 0.8 pt " +
                       series_point(curve.style) + style + title_of(curve));
  }
  return elements;
}

std::string legend_title(const SweepFigure& input) {
  return input.legend.empty() ? "" : " title " + gnuplot_text(input.legend);
}

/// Two entries stand side by side, three short ones that have a title above them.
std::size_t legend_rows(const SweepFigure& input) {
  std::size_t entries = 0;
  for (const SweepPanel& panel : input.panels) {
    const auto labelled =
        std::count_if(panel.curves.begin(), panel.curves.end(),
                      [](const SweepCurve& curve) { return !curve.label.empty(); });
    entries = std::max(entries, static_cast<std::size_t>(labelled));
  }
  return input.legend.empty() ? (entries + 1) / 2 : (entries + 2) / 3;
}

/// Shares end at 100 and begin at 0, or higher up where all are high.
std::string percent_range(const SweepFigure& input) {
  double least = 100.0, most = 0.0;
  for (const SweepPanel& panel : input.panels) {
    for (const SweepCurve& curve : panel.curves) {
      for (const SweepPoint& point : curve.points) {
        least = std::min({least, point.middle, std::isfinite(point.low) ? point.low : 100.0});
        most = std::max({most, point.middle, std::isfinite(point.high) ? point.high : 0.0});
      }
    }
  }
  const double low = least >= 50.0 ? 10.0 * std::floor(least / 10.0) : 0.0;
  const double high = most > 50.0 ? 100.0 : std::max(1.0, most);
  return "[" + number(low - 0.015 * (high - low)) + ":" + number(high + 0.03 * (high - low)) + "]";
}

void set_axes(Figure& figure, const SweepFigure& input, const SweepScale& scale) {
  if (scale.log) figure << "set logscale x";
  if (input.log_y) figure << "set logscale y";
  figure << tics_of(input.axis, scale)
         << "set xrange [" + number(scale.low) + ":" + number(scale.high) + "]"
         << "set xlabel " + gnuplot_text(input.axis.label)
         << "set ylabel " + gnuplot_text(input.y_label);
  if (input.percent) {
    figure << "set yrange " + percent_range(input);
  } else if (!input.log_y) {
    figure << "set yrange [0:*]";
  }
}

}  // namespace

ReportFigure draw_sweep(const std::filesystem::path& folder, const SweepFigure& input) {
  const SweepScale scale = scale_of(input.axis);
  const std::size_t panels = input.panels.size();
  const std::size_t entry_rows = legend_rows(input);
  const std::size_t key_rows = entry_rows + (input.legend.empty() ? 0 : 1);
  Figure figure(folder, input.name, panels > 1 ? 520 * static_cast<int>(panels) : 860,
                480 + 24 * static_cast<int>(key_rows));
  if (panels > 1) {
    figure << "set multiplot layout 1," + std::to_string(panels) + " title " +
                  gnuplot_text(input.title + ": " + input.protocol);
  } else {
    figure.title(input.title, input.protocol);
  }
  set_axes(figure, input, scale);
  // Room for tics, label and legend, in letters: gnuplot's own guess cuts the label.
  figure << "set key below vertical maxrows " + std::to_string(entry_rows) + legend_title(input)
         << "set bmargin " + number(4.2 + 1.5 * static_cast<double>(key_rows) +
                                    (has_long_words(input.axis) ? 2.0 : 0.0));
  for (const SweepPanel& panel : input.panels) {
    const auto elements = panel_elements(figure, panel, scale, input.log_y);
    if (panels > 1) figure << "set title " + gnuplot_text(panel.title);
    if (elements.empty()) {
      if (panels > 1) figure << "set multiplot next";
      continue;
    }
    figure.plot(elements);
  }
  if (panels > 1) figure << "unset multiplot";
  return figure.draw(input.title, input.caption);
}

}  // namespace honka::eval
