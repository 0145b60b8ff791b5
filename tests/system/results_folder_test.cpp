// What a results folder holds, and that it is replaced as a whole.
#include <map>

#include "eval/io/table.h"
#include "tests/system/program.h"

namespace {

using honka::test::Json;
using honka::test::keys;
using honka::test::read_json;
using honka::test::read_text;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_raw;
using honka::test::write_tiny;
using Names = std::vector<std::string>;

std::string base64(const std::string& bytes) {
  static const std::string kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (int k = 3; k >= 0; --k) text += kDigits[group >> (6 * k) & 63U];
  }
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  return text.replace(text.size() - padding, padding, padding, '=');
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void run_tiny(const TemporaryFolder& folder) {
  write_tiny(folder);
  REQUIRE(run_honka({"run", "tiny.toml", "--out", "out"}, folder.path()).exit_code == 0);
}

void check_summary(const Json& summary) {
  for (const std::string key : {"schema_version", "context", "scenario", "scenario_hash",
                                "results_digest", "tables", "metrics"}) {
    CHECK(summary.contains(key));
  }
  for (const std::string key : {"commit", "dirty", "compiler", "build_type", "host", "threads",
                                "seed", "start_time", "wall_time_s"}) {
    CHECK(summary["context"].contains(key));
  }
  CHECK(summary["scenario"]["forest.width_m"] == 60.0);
  CHECK(summary["scenario"]["protocol.frames"] == Json{1, 3});
  for (const auto& metric : summary["metrics"]) {
    CHECK(keys(metric) == Names{"value", "unit", "n", "of", "interval", "floor"});
  }
}

void check_results_row(const Json& row) {
  for (const std::string key : {"frames", "trunks", "matching_triangles", "success_rate", "map"}) {
    CHECK(row.contains(key));
  }
  CHECK(row["success_interval"].size() == 2);
  CHECK(row["success_interval"][0] <= row["success_rate"]);
  CHECK(row["success_rate"] <= row["success_interval"][1]);
  for (const std::string key :
       {"translation_error_m", "rotation_error_deg", "error_to_odometry_m"}) {
    CHECK(keys(row[key]) == Names{"mean", "std", "max"});
  }
  CHECK(keys(row["time_ms"]) == Names{"p50", "p95"});
  CHECK(row["paper"]["trunks"].is_number());
  const double parts = row["success_rate"].get<double>() + row["wrong_rate"].get<double>() +
                       row["refused_rate"].get<double>();
  CHECK(parts == Approx(1.0));
}

void check_table1(const Json& table) {
  const Json& rows = table["rows"];
  REQUIRE(rows.size() == 4);
  for (const Json& row : rows) check_results_row(row);
  for (std::size_t i : {0, 1}) {
    CHECK(rows[i]["map"] == "prior_run");
    CHECK(rows[i]["variant"] == "default");
    CHECK(rows[i + 2]["map"] == "same_run");
    CHECK(rows[i]["frames"] == (i == 0 ? 1 : 3));
    CHECK(rows[i]["windows"] == rows[i + 2]["windows"]);
  }
  CHECK(table["columns"] == keys(rows[0]));
  CHECK(table["paper"]["1"]["success_rate"] == 0.2289);
  CHECK_THAT(table["protocol"].get<std::string>(), Catch::Contains("disjoint"));
}

/// Rows of a window answer for the same place, whatever their frames and variant.
void check_places(const honka::eval::Table& frames) {
  std::map<std::int64_t, std::array<double, 3>> places;
  for (std::size_t row = 0; row < frames.rows(); ++row) {
    const std::array<double, 3> place = {frames.doubles("true_x_m")[row],
                                         frames.doubles("true_y_m")[row],
                                         frames.doubles("true_yaw_rad")[row]};
    const auto [known, is_new] = places.try_emplace(frames.ints("window")[row], place);
    CHECK((is_new || known->second == place));
  }
  CHECK(places.size() * 4 == frames.rows());
}

}  // namespace

TEST_CASE("summary.json has every key and the rows of table1, the default first") {
  const TemporaryFolder folder;
  run_tiny(folder);
  const Json summary = read_json(folder / "out/summary.json");
  check_summary(summary);
  check_table1(summary["tables"]["table1"]);
  CHECK(summary["metrics"]["success_default_c1"]["of"] ==
        summary["tables"]["table1"]["rows"][0]["windows"]);

  SECTION("trials.h5 holds the rows that the table was made of") {
    const auto trials = honka::eval::read_table(folder / "out/trials.h5", "trials");
    const auto frames = honka::eval::read_table(folder / "out/trials.h5", "frames");
    CHECK(trials.rows() == 1);
    CHECK(static_cast<std::int64_t>(frames.rows()) == 4 * trials.ints("windows")[0]);
    CHECK(honka::eval::results_digest({&trials, &frames}) == summary["results_digest"]);
    check_places(frames);
    CHECK(frames.column("x_m").unit == "m");
    CHECK(frames.column("x_m").frame == "map");
    const auto context = honka::eval::read_context_h5(folder / "out/trials.h5");
    CHECK(context.at("seed") == "1");
  }
}

TEST_CASE("the report holds every figure, opens offline and is rebuilt equal") {
  const TemporaryFolder folder;
  run_tiny(folder);
  const std::string html = read_text(folder / "out/report.html");
  std::size_t figures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out/figures")) {
    const auto extension = entry.path().extension();
    if (extension != ".png" && extension != ".svg") continue;
    ++figures;
    auto script = entry.path();
    CHECK(std::filesystem::exists(script.replace_extension(".gp")));
    CHECK(std::filesystem::exists(script.replace_extension(".dat")));
    CAPTURE(entry.path());
    CHECK(holds(html, "base64," + base64(read_text(entry.path())) + "\""));
  }
  CHECK(figures >= 10);
  for (const std::string link : {"src=\"http", "src=\"figures", "<link", "<script src"}) {
    CHECK_FALSE(holds(html, link));
  }

  SECTION("honka report") {
    write_raw(folder / "out/report.html", "lost");
    const auto outcome = run_honka({"report", "out"}, folder.path());
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(read_text(folder / "out/report.html") == html);
  }
}

TEST_CASE("a second run replaces the folder as a whole, a failed one leaves it") {
  const TemporaryFolder folder;
  run_tiny(folder);
  write_raw(folder / "out/notes.txt", "of the first run");
  const auto before = honka::test::contents(folder / "out");
  const auto refused =
      run_honka({"run", "tiny.toml", "--out", "out", "-s", "protocol.frames=[100]"}, folder.path());
  CHECK(refused.exit_code == 2);
  CHECK(honka::test::contents(folder / "out") == before);
  REQUIRE(run_honka({"run", "tiny.toml", "--out", "out/"}, folder.path()).exit_code == 0);
  CHECK_FALSE(std::filesystem::exists(folder / "out/notes.txt"));
  CHECK(std::filesystem::exists(folder / "out/report.html"));
  CHECK(folder.entries() == 2);
}

TEST_CASE("without --out the results go under results/ at the scenario's path") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "scenarios/own");
  write_tiny(folder, "scenarios/own/tiny.toml");
  REQUIRE(run_honka({"run", "scenarios/own/tiny.toml"}, folder.path()).exit_code == 0);
  CHECK(std::filesystem::exists(folder / "results/own/tiny/summary.json"));
}

TEST_CASE("the map of the same run alone makes a table too") {
  const TemporaryFolder folder;
  write_tiny(folder);
  REQUIRE(
      run_honka({"run", "tiny.toml", "--out", "out", "-s", "map.source=same_run"}, folder.path())
          .exit_code == 0);
  const Json rows = read_json(folder / "out/summary.json")["tables"]["table1"]["rows"];
  REQUIRE(rows.size() == 2);
  for (const Json& row : rows) CHECK(row["map"] == "same_run");
}
