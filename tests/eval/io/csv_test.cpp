#include "eval/io/csv.h"

#include "tests/eval/io/temporary_folder.h"

using namespace honka;
using namespace honka::eval;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

TEST_CASE("stem CSV: any column order, comments, CRLF, blank lines, empty optional cells") {
  const TemporaryFolder folder;
  write_raw(folder / "a.csv",
            "\xEF\xBB\xBF# a comment, with commas\r\n\r\n"
            "id,height_m,species,y_m,x_m,dbh_m\r\n"
            "7,21.5,\"Scots pine, old\",2.25,-1.5,0.31\r\n"
            "  # another\r\n"
            "8,, spruce , +3e1 ,4,\r\n\r\n");
  const StemMap stems = read_stem_csv(folder / "a.csv");
  REQUIRE(stems.size() == 2);
  CHECK(stems[0].position_m == Eigen::Vector2d(-1.5, 2.25));
  CHECK(stems[0].height_m == 21.5);
  CHECK(stems[0].dbh_m == 0.31);
  CHECK_FALSE(stems[0].z_m.has_value());
  CHECK(stems[1].position_m == Eigen::Vector2d(4.0, 30.0));
  CHECK_FALSE(stems[1].height_m.has_value());
  CHECK_FALSE(stems[1].dbh_m.has_value());
}

TEST_CASE("stem CSV: heights that are asked for must be there, and are told by their place") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) {
    write_raw(folder / "z.csv", text);
    return read_stem_csv(folder / "z.csv", StemList::kMayBeEmpty, StemHeights::kNeeded);
  };
  CHECK(read("x_m,y_m,z_m\n1,2,-3.5\n").at(0).z_m == -3.5);
  CHECK(read("z_m,x_m,y_m\n").empty());
  CHECK_THAT(user_error_of([&] { (void)read("x_m,y_m\n1,2\n"); }),
             Catch::Contains("z.csv:1:1: no column 'z_m'"));
  CHECK_THAT(user_error_of([&] { (void)read("x_m,y_m,Z_m\n1,2,3\n"); }),
             Catch::Contains("z.csv:1:9: no column 'z_m'; did you mean 'z_m' by 'Z_m'?"));
  CHECK_THAT(user_error_of([&] { (void)read("x_m,y_m,z_m\n1,2,3\n4,5,\n"); }),
             Catch::Contains("z.csv:3:5: column 'z_m' is empty"));
  CHECK_THAT(user_error_of([&] { (void)read("x_m,y_m,z_m\n1,2,inf\n"); }),
             Catch::Contains("z.csv:2:5"));
}

TEST_CASE("stem CSV: a list goes round bit for bit, at UTM size too") {
  const TemporaryFolder folder;
  StemMap stems(3);
  stems[0] = {{674321.123, 7012345.678}, 151.0 / 7.0, 0.1 + 0.2, {}, 12};
  stems[1] = {{-0.0, 1e-300}, {}, {}, 21.3, 0};
  stems[2] = {{1.0 / 3.0, 5e-324}, {}, {}, {}, 3};
  write_stem_csv(folder / "b.csv", stems);
  CHECK(read_stem_csv(folder / "b.csv") == stems);
  const StemMap bare = {{{1.0, 2.0}, {}, {}, {}, 0}};
  write_stem_csv(folder / "b.csv", bare);
  CHECK(read_stem_csv(folder / "b.csv") == bare);
  CHECK(folder.entries() == 1);
}

TEST_CASE("stem CSV: what bad input gets, with line and column") {
  const TemporaryFolder folder;
  const std::string path = (folder / "bad.csv").string();
  struct Bad {
    std::string content, error;
  };
  const std::vector<Bad> cases = {
      {"", ": empty; give a header x_m,y_m and a row for each stem"},
      {"# only\n\n", ": empty; give a header x_m,y_m and a row for each stem"},
      {"x_m,y_m\n", ":1:1: a header and no stems; give a row for each stem"},
      {"1,2\n3,4\n", ":1:1: no header; add a first line that names the columns: x_m,y_m"},
      {"#c\nx_m,ym\n1,2\n", ":2:5: no column 'y_m'; did you mean 'y_m' by 'ym'?"},
      {"X_M,y_m\n1,2\n", ":1:1: no column 'x_m'; did you mean 'x_m' by 'X_M'?"},
      {"x_m;y_m\n1;2\n", ":1:1: no column 'x_m'; separate the columns by commas"},
      {"x_m,species\n1,pine\n", ":1:1: no column 'y_m'; a stem list needs the columns x_m and y_m"},
      {"x_m,y_m,x_m\n1,2,3\n", ":1:9: column 'x_m' a second time; take one out"},
      {"x_m,y_m\n1,2\n1,two\n",
       ":3:3: column 'y_m': 'two' is not a number; use digits and a decimal point"},
      {"x_m,y_m\n1, 2m\n",
       ":2:4: column 'y_m': '2m' is not a number; use digits and a decimal point"},
      {"x_m,y_m\nnan,2\n",
       ":2:1: column 'x_m': 'nan' is not finite; mend the number or take the row out"},
      {"x_m,y_m\n1,-inf\n",
       ":2:3: column 'y_m': '-inf' is not finite; mend the number or take the row out"},
      {"x_m,y_m\n1,1e999\n", ":2:3: column 'y_m': '1e999' is beyond what a double holds"},
      {"x_m,y_m\n1,\n", ":2:3: column 'y_m': empty; give a number or take the row out"},
      {"x_m,y_m\n1,2,3\n", ":2:1: 3 cells where the header has 2; add or take out commas"},
      {"x_m,y_m\n1\n", ":2:1: 1 cells where the header has 2; add or take out commas"},
      {"x_m,y_m,dbh_m\n1,2,31\n",
       ":2:5: column 'dbh_m': 31 is outside 0 to 12 m; give metres, or leave the cell empty if "
       "not known"},
  };
  for (const Bad& bad : cases) {
    write_raw(path, bad.content);
    CHECK(user_error_of([&] { (void)read_stem_csv(path); }) == path + bad.error);
  }
  CHECK(user_error_of([&] { (void)read_stem_csv(folder / "none.csv"); }) ==
        (folder / "none.csv").string() + ": no such file; check the path");
  CHECK(user_error_of([&] { (void)read_stem_csv(folder.path()); }) ==
        folder.path().string() + ": is a folder; give the name of a file");
}

TEST_CASE("stem CSV: the measured plots can be read") {
  const auto data = std::filesystem::path(HONKA_SOURCE_DIR).parent_path() / "shared" / "data";
  if (!std::filesystem::exists(data / "stem_maps")) {
    WARN("skipped: no " << (data / "stem_maps"));
    return;
  }
  std::size_t lists = 0;
  for (const char* set : {"stem_maps", "paired_stem_maps"}) {
    for (const auto& entry : std::filesystem::directory_iterator(data / set)) {
      if (entry.path().extension() != ".csv") continue;
      CHECK(read_stem_csv(entry.path()).size() > 5);
      ++lists;
    }
  }
  CHECK(lists >= 18);
}
