#include "eval/report/summary.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "tests/eval/report/figure_folder.h"

using namespace honka::eval;
using honka::test::FigureFolder;

namespace {

ReportModel some_report() {
  ReportModel model;
  model.title = "Table 1 of Li et al. 2020 <script>alert(\"1\")</script>";
  model.question = "Does success rise with the number of frames & does C10 reach 95 %?";
  model.lead_notes = {"Aggregation uses truth + noise: 0.02 m and 0.1° a key frame."};
  ReportTable table;
  table.title = "Table 1";
  table.protocol = "success: at least 3 agreeing matches, within 0.5 m and 2.5°";
  table.headers = {{"map"}, {"frames"}, {"trunks"}, {"success", "%"}, {"match, p50", "ms"}};
  table.rows = {{{"prior run"}, {"1"}, compared(55.2, 54.09, 2), compared(24.3, 22.89, 2), {"1.9"}},
                {{"prior run"}, {"10"}, compared(172.0, 133.96, 2), compared(100, 100, 2), {"2.4"}},
                {{"same run"}, {"1"}, {"56.0"}, {"43.1"}, {"2.0"}}};
  table.notes = {"The paper gives no interval."};
  model.tables = {table};
  model.figures = {{"figures/dot.svg", "A dot", "One dot."},
                   {"figures/gone.svg", "Gone", "Was removed."},
                   {"", "Undrawn", "No gnuplot.", "Not drawn: install gnuplot-nox"}};
  model.protocol = {"210 disjoint windows over 3 stands"};
  model.scenario_text = "[forest]\ndensity_per_ha = 367  # a < b\n";
  model.reproduce = "honka run scenarios/li2020/table1.toml --seed 1";
  return model;
}

Summary some_summary() {
  Summary summary;
  summary.context = {{"commit", "abc"}, {"host", "tammi"}};
  summary.scenario = {{"forest", {{"density_per_ha", 367}}}, {"a_later_key", 0.1}};
  summary.scenario_hash = "1234";
  summary.results_digest = "5678";
  SummaryTable table;
  table.columns = {"frames", "success_rate"};
  table.rows = {{{"frames", 1}, {"success_rate", 0.1 + 0.2}, {"paper", {{"success_rate", .2289}}}}};
  table.paper = {{"source", "Li2020 Table 1"}};
  table.protocol = "default";
  summary.tables["table1"] = table;
  summary.metrics["success_c1"] = {1.0 / 3.0, "1", 70, 210, {{0.27, 0.4}}, {}};
  summary.metrics["unknown"] = {std::nan(""), "m", 0, 0, {}, 0.05};
  summary.report = some_report();
  return summary;
}

std::string error_of(const std::filesystem::path& path) {
  try {
    (void)read_summary(path);
  } catch (const honka::UserError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("report: the paper's figure, ours, and the difference with its sign") {
  CHECK(compared(55.2, 54.09, 2) == ReportCell{"55.20", "54.09", "+1.11"});
  CHECK(compared(22.0, 22.89, 2) == ReportCell{"22.00", "22.89", "−0.89"});
  CHECK(compared(1.001, 1.0, 2) == ReportCell{"1.00", "1.00", "0.00"});
  CHECK(compared(0.999, 1.0, 2) == ReportCell{"1.00", "1.00", "0.00"});
  CHECK(compared(std::nan(""), 1.0, 1) == ReportCell{"–", "1.0", ""});
  CHECK(compared(2.0, {}, 1) == ReportCell{"2.0", "", ""});
}

TEST_CASE("summary: goes round in full precision, NaN is null") {
  const FigureFolder folder;
  const auto path = folder.root() / "summary.json";
  const Summary summary = some_summary();
  write_summary(path, summary);
  const std::string text = read_text_file(path);
  CHECK(text.find("0.30000000000000004") != std::string::npos);
  const Json json = Json::parse(text);
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  CHECK(keys == std::vector<std::string>{"schema_version", "context", "scenario", "scenario_hash",
                                         "results_digest", "tables", "metrics", "report"});
  CHECK(json["metrics"]["unknown"]["value"].is_null());
  CHECK(json["tables"]["table1"]["rows"][0]["paper"]["success_rate"] == 0.2289);
  const Summary back = read_summary(path);
  CHECK(back.tables.at("table1") == summary.tables.at("table1"));
  CHECK(back.scenario == summary.scenario);
  CHECK(back.metrics.at("success_c1").value == 1.0 / 3.0);
  CHECK(back.metrics.at("success_c1").interval == summary.metrics.at("success_c1").interval);
  CHECK(std::isnan(back.metrics.at("unknown").value));
  CHECK(back.metrics.at("unknown").floor == 0.05);
  ReportModel expected = some_report();
  expected.context = summary.context;
  expected.scenario_hash = "1234";
  expected.results_digest = "5678";
  CHECK(back.report == expected);
}

TEST_CASE("summary: bad files give one line that names them") {
  const FigureFolder folder;
  const auto path = folder.root() / "summary.json";
  std::filesystem::remove(path);
  CHECK(error_of(path).find("summary.json: no such file") != std::string::npos);
  for (const char* text : {"{", "[]", "{}", "{\"schema_version\": \"one\"}",
                           "{\"schema_version\": 1, \"context\": 3}"}) {
    write_file_safely(path, text);
    CHECK(error_of(path).find("summary.json: not a summary that honka wrote") != std::string::npos);
  }
  write_file_safely(path, "{\"schema_version\": 99}");
  CHECK(error_of(path).find("use a newer honka") != std::string::npos);
}

TEST_CASE("HTML report: escaped, offline, complete, made again from the summary") {
  const FigureFolder folder;
  write_file_safely(folder.path() / "dot.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>");
  write_summary(folder.root() / "summary.json", some_summary());
  rebuild_report(folder.root());
  const std::string html = read_text_file(folder.root() / "report.html");
  const auto has = [&](const std::string& text) { return html.find(text) != std::string::npos; };
  CHECK_FALSE(has("<script"));
  CHECK(has("&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;"));
  CHECK(has("frames &amp; does"));
  CHECK(has("a &lt; b"));
  CHECK(has("data:image/svg+xml;base64,PHN2ZyB4bWxucz0naHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmcnLz4="));
  CHECK(has("figures/gone.svg is missing"));
  CHECK(has("install gnuplot-nox"));
  CHECK(has("tammi"));
  CHECK(has("5678"));
  CHECK_FALSE(has("src=\"http"));
  CHECK_FALSE(has("<link"));
  CHECK(html.find("Aggregation uses truth") < html.find("<table"));
  CHECK(html_escaped("a<b>&\"'") == "a&lt;b&gt;&amp;&quot;&#39;");
}

TEST_CASE("console table: aligned, paper | ours") {
  const std::string text = console_table(some_report().tables[0]);
  CHECK(text ==
        "Table 1\n"
        "success: at least 3 agreeing matches, within 0.5 m and 2.5°\n"
        "\n"
        "map         frames            trunks           success   match, p50\n"
        "                                                     %           ms\n"
        "                      paper |   ours    paper |   ours\n"
        "-------------------------------------------------------------------\n"
        "prior run        1    54.09 |  55.20    22.89 |  24.30          1.9\n"
        "prior run       10   133.96 | 172.00   100.00 | 100.00          2.4\n"
        "same run         1        – |   56.0        – |   43.1          2.0\n"
        "  The paper gives no interval.\n");
}

TEST_CASE("HTML report: shows the first table of the results beside it, once they exist") {
  const FigureFolder folder;
  const auto one = folder.root() / "one", other = folder.root() / "other";
  for (const auto& path : {one, other}) std::filesystem::create_directories(path);
  Summary summary = some_summary();
  summary.scenario["beside"] = "other";
  summary.scenario["odometry.source"] = "loam";
  summary.report.title = "The one";
  write_summary(one / "summary.json", summary);
  rebuild_report(one);
  CHECK(read_text_file(one / "report.html").find("Beside: ") == std::string::npos);
  summary.scenario["beside"] = "one";
  summary.scenario["odometry.source"] = "truth+noise";
  summary.report.title = "The other";
  write_summary(other / "summary.json", summary);
  rebuild_report(other);
  CHECK(read_text_file(other / "report.html").find("Beside: The one") != std::string::npos);
  CHECK(read_text_file(other / "report.html").find("odometry: loam") != std::string::npos);
  rebuild_report_beside(other);
  CHECK(read_text_file(one / "report.html").find("Beside: The other") != std::string::npos);
}
