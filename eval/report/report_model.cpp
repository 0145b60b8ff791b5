#include "eval/report/report_model.h"

#include <cmath>
#include <cstdio>

namespace honka::eval {

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, value);
  const std::string number = text;
  // −0.00 is 0.00
  return number.find_first_of("123456789") == std::string::npos && number[0] == '-'
             ? number.substr(1)
             : number;
}

ReportCell compared(double ours, std::optional<double> paper, int decimals) {
  ReportCell cell{fixed(ours, decimals)};
  if (!paper) return cell;
  cell.paper = fixed(*paper, decimals);
  if (std::isfinite(ours)) {
    cell.difference = fixed(ours - *paper, decimals);
    const bool zero = cell.difference.find_first_of("123456789") == std::string::npos;
    if (ours > *paper && !zero) cell.difference.insert(0, "+");
    if (cell.difference[0] == '-') cell.difference.replace(0, 1, "−");
  }
  return cell;
}

}  // namespace honka::eval
