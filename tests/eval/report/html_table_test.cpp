#include <catch2/catch.hpp>

#include "eval/report/html_report.h"

using namespace honka::eval;

TEST_CASE("a column of sentences reads from the left, names and numbers do not") {
  ReportModel model;
  ReportTable& table = model.tables.emplace_back();
  table.headers = {{"point"}, {"n"}, {"verdict"}};
  table.rows = {{{"a point whose name is longer than any sentence needs to be"}, {"12"}, {"short"}},
                {{"b"}, {"7"}, {"robust succeeds more often than plain: +20.0 %"}}};
  const std::string html = render_html(model, ".");
  CHECK(html.find("<th class=\"sentence\">verdict</th>") != std::string::npos);
  CHECK(html.find("<td class=\"sentence\">short</td>") != std::string::npos);
  CHECK(html.find("<td>12</td>") != std::string::npos);
  CHECK(html.find("<td>b</td>") != std::string::npos);
}
