#include "eval/report/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>

#include "algo/types/check.h"
#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"

namespace honka::eval {
namespace {

constexpr const char* kStyle = R"(set encoding utf8
set colorsequence podo
set border 3 lw 1 lc '#444444'
set tics nomirror out tc '#222222'
set grid lw 0.5 lc '#DDDDDD'
set key opaque samplen 2 spacing 1.1
set datafile missing 'NaN'
)";

std::string terminal(const std::string& extension, const std::string& name, int width, int height) {
  const std::string size = std::to_string(width) + "," + std::to_string(height);
  const std::string kind =
      extension == "svg"
          ? "set terminal svg size " + size + " font 'DejaVu Sans,13' enhanced rounded"
          // Twice the size, so that it is sharp on a fine screen and in print.
          : "set terminal pngcairo size " + size + " fontscale 1 font 'DejaVu Sans,11' enhanced";
  return "# Draw again: gnuplot " + name + ".gp\n" + kind + " background rgb 'white'\n" +
         "set output '" + name + "." + extension + "'\n";
}

void append_number(std::string& text, double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.7g", value);
  text += std::isfinite(value) ? buffer : "NaN";
}

/// Runs gnuplot on a script inside a folder; its complaints go to `log`. Its exit code, 127 when
/// there is no gnuplot.
int run_gnuplot(const std::filesystem::path& folder, const std::string& script,
                const std::filesystem::path& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::string program = "gnuplot", argument = script;
  const std::array<char*, 3> arguments = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error =
      ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return 127;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// In gnuplot's enhanced text these are markup; a backslash takes that away.
std::string without_markup(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    if (std::string("_^{}@&~\\").find(c) != std::string::npos) plain += "\\\\";
    if (c == '"') plain += '\\';
    plain += c;
  }
  return plain;
}

}  // namespace

Figure::Figure(std::filesystem::path folder, std::string name, int width_px, int height_px,
               Format format)
    : folder_(std::move(folder)),
      name_(std::move(name)),
      extension_(format == Format::kSvg ? "svg" : "png"),
      height_px_(height_px) {
  script_ = terminal(extension_, name_, width_px, height_px) + kStyle;
}

std::string Figure::data(const std::string& what, const std::vector<std::vector<double>>& columns) {
  data_ += (blocks_ == 0 ? "# " : "\n\n# ") + what + "\n";
  const std::size_t rows = columns.empty() ? 0 : columns.front().size();
  for (const auto& column : columns) HONKA_CHECK(column.size() == rows, "columns of one block");
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i > 0) data_ += ' ';
      append_number(data_, columns[i][row]);
    }
    data_ += '\n';
  }
  empty_ = empty_ && rows == 0;
  if (rows == 0) data_ += "NaN NaN NaN NaN\n";
  return "'" + name_ + ".dat' index " + std::to_string(blocks_++);
}

std::string Figure::data(const std::string& what, const std::vector<Eigen::Vector2d>& points) {
  std::vector<std::vector<double>> columns(2);
  for (const auto& point : points) {
    columns[0].push_back(point.x());
    columns[1].push_back(point.y());
  }
  return data(what, columns);
}

std::string Figure::lines(const std::string& what,
                          const std::vector<std::vector<Eigen::Vector2d>>& polylines) {
  data_ += (blocks_ == 0 ? "# " : "\n\n# ") + what + "\n";
  bool any = false;
  for (const auto& polyline : polylines) {
    if (any && !polyline.empty()) data_ += '\n';
    for (const auto& point : polyline) {
      append_number(data_, point.x());
      data_ += ' ';
      append_number(data_, point.y());
      data_ += '\n';
      any = true;
    }
  }
  empty_ = empty_ && !any;
  if (!any) data_ += "NaN NaN NaN NaN\n";
  return "'" + name_ + ".dat' index " + std::to_string(blocks_++);
}

Figure& Figure::operator<<(const std::string& line) {
  script_ += line + "\n";
  return *this;
}

Figure& Figure::title(const std::string& title, const std::string& protocol) {
  title_ = "\"{/:Bold " + without_markup(title) + "}";
  if (!protocol.empty()) title_ += "\\n{/*0.85 " + without_markup(protocol) + "}";
  title_ += "\"";
  return *this << "set title " + title_;
}

Figure& Figure::key_below(int margin_px) {
  return *this << "set key at screen 0.5,screen 0.015 center bottom horizontal"
               << "set bmargin at screen " + number(double(margin_px) / height_px_);
}

Figure& Figure::plot(const std::vector<std::string>& elements) {
  std::string command = "plot ";
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (i > 0) command += ", \\\n     ";
    command += elements[i];
  }
  return *this << command;
}

ReportFigure Figure::draw(const std::string& report_title, const std::string& caption) {
  ReportFigure figure{"", report_title, caption};
  if (empty_) {
    figure.notice = "Not drawn: the run gave no data for this figure.";
    return figure;
  }
  write_file_safely(folder_ / (name_ + ".dat"), data_ + "\n");
  write_file_safely(folder_ / (name_ + ".gp"), script_);
  const auto folder = std::filesystem::absolute(folder_);
  const auto log = folder / (name_ + ".log");
  const int exit_code = run_gnuplot(folder, name_ + ".gp", log);
  const std::string complaint = std::filesystem::exists(log) ? read_text_file(log) : "";
  std::error_code ignored;
  std::filesystem::remove(log, ignored);
  if (exit_code == 127) {
    figure.notice = "Not drawn: gnuplot is not installed; install the package gnuplot-nox, then " +
                    std::string("run 'gnuplot ") + name_ + ".gp' in figures/ and 'honka report'.";
    return figure;
  }
  const std::string file = name_ + "." + extension_;
  if (exit_code != 0 || !std::filesystem::exists(folder_ / file)) {
    throw RunError((folder_ / (name_ + ".gp")).string() + ": gnuplot refused it: " +
                   complaint.substr(0, complaint.find_last_not_of('\n') + 1));
  }
  figure.file = folder_.filename().string() + "/" + file;
  return figure;
}

std::string gnuplot_text(const std::string& text) { return "\"" + without_markup(text) + "\""; }

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string series_colour(std::size_t i) {
  constexpr std::array<const char*, 6> kColours = {kBlue, kOrange, kGreen, kRed, kPink, kBlack};
  return kColours[i % kColours.size()];
}

std::string series_point(std::size_t i) {
  constexpr std::array<int, 6> kPoints = {7, 5, 9, 13, 11, 6};
  return std::to_string(kPoints[i % kPoints.size()]);
}

std::string frames_label(std::int64_t frames) {
  return std::string("C").append(std::to_string(frames));
}

}  // namespace honka::eval
