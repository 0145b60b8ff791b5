#include "eval/study/trial_record.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <iterator>

#include "eval/io/table.h"
#include "eval/io/text_table.h"

namespace honka::eval {
namespace {

constexpr std::array<std::string_view, 5> kStatusNames = {"done", "threw", "timed_out",
                                                          "out_of_memory", "crashed"};
constexpr std::size_t kChecksumDigits = 12;

std::string checksum(std::string_view text) { return sha256_hex(text).substr(0, kChecksumDigits); }

/// Cells are apart by tabs, so that a cause may hold none.
std::string one_cell(std::string text) {
  for (char& c : text) {
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

/// Takes a line apart, cell by cell; `good()` is false once something did not fit.
class Cells {
 public:
  explicit Cells(std::string_view line) : rest_(line) {}

  [[nodiscard]] std::string_view next() {
    if (done_) good_ = false;
    const std::size_t tab = rest_.find('\t');
    const std::string_view cell = rest_.substr(0, tab);
    done_ = tab == std::string_view::npos;
    rest_ = done_ ? std::string_view() : rest_.substr(tab + 1);
    return cell;
  }
  template <class Number>
  [[nodiscard]] Number number() {
    const std::string_view cell = next();
    Number value{};
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size()) good_ = false;
    return value;
  }
  [[nodiscard]] bool good() const { return good_; }
  [[nodiscard]] bool at_end() const { return done_; }

 private:
  std::string_view rest_;
  bool done_ = false, good_ = true;
};

TrialStatus status_of(std::string_view name, bool& known) {
  for (std::size_t k = 0; k < kStatusNames.size(); ++k) {
    if (kStatusNames[k] == name) return static_cast<TrialStatus>(k);
  }
  known = false;
  return TrialStatus::kThrew;
}

}  // namespace

std::string_view name_of(TrialStatus status) {
  return kStatusNames[static_cast<std::size_t>(status)];
}

std::string to_line(const TrialRecord& record) {
  std::string text =
      fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}", record.id.point, record.id.trial,
                  name_of(record.status), one_cell(record.cause), exact_text(record.wall_s),
                  exact_text(record.cpu_s), record.resident_bytes, record.results.size());
  for (const MethodResult& result : record.results) {
    fmt::format_to(std::back_inserter(text), "\t{}\t{}", one_cell(result.method),
                   result.values.size());
    for (const double value : result.values) text += "\t" + exact_text(value);
  }
  return checksum(text) + "\t" + text;
}

std::optional<TrialRecord> from_line(std::string_view line) {
  if (line.size() <= kChecksumDigits || line[kChecksumDigits] != '\t') return std::nullopt;
  const std::string_view text = line.substr(kChecksumDigits + 1);
  if (checksum(text) != line.substr(0, kChecksumDigits)) return std::nullopt;
  Cells cells(text);
  bool known = true;
  TrialRecord record;
  record.id = {cells.number<std::int64_t>(), cells.number<std::int64_t>()};
  record.status = status_of(cells.next(), known);
  record.cause = std::string(cells.next());
  record.wall_s = cells.number<double>();
  record.cpu_s = cells.number<double>();
  record.resident_bytes = cells.number<std::int64_t>();
  const auto methods = cells.number<std::size_t>();
  for (std::size_t m = 0; m < methods && cells.good(); ++m) {
    MethodResult& result = record.results.emplace_back();
    result.method = std::string(cells.next());
    const auto values = cells.number<std::size_t>();
    for (std::size_t k = 0; k < values && cells.good(); ++k) {
      result.values.push_back(cells.number<double>());
    }
  }
  if (!known || !cells.good() || !cells.at_end()) return std::nullopt;
  return record;
}

}  // namespace honka::eval
