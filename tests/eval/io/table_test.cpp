#include "eval/io/table.h"

#include <cmath>
#include <limits>

#include "eval/io/safe_file.h"
#include "tests/eval/io/temporary_folder.h"

using namespace honka::eval;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

namespace {

Table small_table() {
  Table table({{"trial", "", "number of the trial", std::vector<std::int64_t>{}},
               {"x_m", "m", "position", std::vector<double>{}, true, "map"},
               {"verdict", "", "what the matcher said", std::vector<std::string>{}},
               {"match_ms", "ms", "time of the match", std::vector<double>{}, false}});
  table.add_row(std::int64_t{0}, 0.25, "accepted", 1.5);
  table.add_row(std::int64_t{-3}, -0.0, "ääni", 2.5);
  return table;
}

}  // namespace

TEST_CASE("digest: known answers") {
  // Made by hand with Python: hashlib.sha256(struct.pack("<qd", 0, .25) + struct.pack("<Q", 8) +
  // b"accepted" + struct.pack("<qd", -3, 0.) + struct.pack("<Q", 6) + "ääni".encode()).
  CHECK(results_digest({}) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  const Table table = small_table();
  CHECK(results_digest({&table}) ==
        "3119bf2f371014f341ca448b960da48d1ab493f339e7ab7bfe0bd79e4210e969");
}

TEST_CASE("digest: times are left out, -0 is 0, every NaN is one, all else counts") {
  const Table table = small_table();
  const std::string digest = results_digest({&table});
  const auto changed = [](auto change) {
    auto columns = small_table().columns();
    change(columns);
    const Table other(std::move(columns));
    return results_digest({&other});
  };
  CHECK(changed([](auto& c) { std::get<0>(c[3].values)[0] = 99.0; }) == digest);
  CHECK(changed([](auto& c) { std::get<0>(c[1].values)[1] = 0.0; }) == digest);
  CHECK(changed([](auto& c) { std::get<0>(c[1].values)[1] = 5e-324; }) != digest);
  CHECK(changed([](auto& c) { std::get<1>(c[0].values)[1] = 3; }) != digest);
  CHECK(changed([](auto& c) { std::get<2>(c[2].values)[0] = "refused"; }) != digest);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(changed([&](auto& c) { std::get<0>(c[1].values)[1] = nan; }) ==
        changed([&](auto& c) { std::get<0>(c[1].values)[1] = std::copysign(nan, -1.0); }));
  CHECK(results_digest({&table, &table}) != digest);
}

TEST_CASE("table: rows, columns and joining") {
  Table table = small_table();
  table.append_rows(small_table());
  CHECK(table.rows() == 4);
  CHECK(table.doubles("x_m")[2] == 0.25);
  CHECK(table.ints("trial")[3] == -3);
  CHECK(table.strings("verdict")[1] == "ääni");
  CHECK(table.has("match_ms"));
  CHECK_FALSE(table.has("nothing"));
}

TEST_CASE("trials.h5: goes round bit for bit, with units, frames and context") {
  const TemporaryFolder folder;
  const Table trials = small_table();
  Table frames({{"trial", "", "key", std::vector<std::int64_t>{}}});
  write_trials_h5(folder / "trials.h5", {{"commit", "abc"}, {"host", "tammi"}}, trials, frames);
  const Table back = read_table(folder / "trials.h5", "trials");
  CHECK(back == trials);
  CHECK(std::signbit(back.doubles("x_m")[1]));
  CHECK(read_table(folder / "trials.h5", "frames") == frames);
  CHECK(read_context_h5(folder / "trials.h5").at("host") == "tammi");
  CHECK(results_digest({&back}) == results_digest({&trials}));
  CHECK(folder.entries() == 1);
}

TEST_CASE("trials.h5: missing, foreign and truncated files") {
  const TemporaryFolder folder;
  const auto line = [&](const std::string& name) {
    return user_error_of([&] { (void)read_table(folder / name, "trials"); });
  };
  CHECK(line("none.h5").find("none.h5: no such file") != std::string::npos);
  write_raw(folder / "text.h5", "x_m,y_m\n1,2\n");
  CHECK(line("text.h5").find("text.h5: not an HDF5 file") != std::string::npos);
  write_trials_h5(folder / "whole.h5", {}, small_table(), {});
  const std::string bytes = read_text_file(folder / "whole.h5");
  for (const double share : {0.99, 0.5, 0.1}) {
    write_raw(folder / "cut.h5",
              bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
    CHECK(line("cut.h5").find("cut.h5: an HDF5 file that is truncated; it is damaged") !=
          std::string::npos);
  }
  CHECK(user_error_of([&] {
          (void)read_table(folder / "whole.h5", "shots");
        }).find("no group /shots") != std::string::npos);
}
