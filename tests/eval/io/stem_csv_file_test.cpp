// A stem list that is changed keeps the text of the rows that stay.
#include "eval/io/stem_csv_file.h"

#include "eval/io/csv.h"
#include "tests/eval/io/temporary_folder.h"

using namespace honka;
using namespace honka::eval;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

TEST_CASE("changed stem CSV: rows that stay keep every column, comment and digit") {
  const TemporaryFolder folder;
  write_raw(folder / "map.csv",
            "# plot 7\n\nid,species,y_m,x_m,dbh_m\n"
            "a1,\"pine, old\",2.250,-1.5,0.31\n"
            "# by hand\n"
            "a2,spruce,30.0000,4,\n"
            "a3,pine,7,8,0.2\n");
  const StemCsvFile file(folder / "map.csv");
  REQUIRE(file.stems().size() == 3);
  CHECK(file.line_of(0) == 4);
  CHECK(file.line_of(1) == 6);
  CHECK(file.id_of(1) == "a2");
  CHECK(file.changed({1}, {{1.0 / 3.0, 7012345.6789}}) ==
        "# plot 7\n\nid,species,y_m,x_m,dbh_m\n"
        "a1,\"pine, old\",2.250,-1.5,0.31\n"
        "# by hand\n"
        "a3,pine,7,8,0.2\n"
        ",,7012345.679,0.333,\n");
}

TEST_CASE(
    "changed stem CSV: unchanged text is the same text, a last line without an end gets one") {
  const TemporaryFolder folder;
  const std::string text = "x_m,y_m\r\n1,2\r\n3,4";
  write_raw(folder / "map.csv", text);
  const StemCsvFile file(folder / "map.csv");
  CHECK(file.id_of(0).empty());
  CHECK(file.changed({}, {}) == text);
  CHECK(file.changed({0}, {{5.0, 6.0}}) == "x_m,y_m\r\n3,4\r\n5.000,6.000\r\n");
  CHECK(file.changed({0, 1}, {}) == "x_m,y_m\r\n");
  write_raw(folder / "new.csv", file.changed({1}, {{-0.0004, 12.0}}));
  CHECK(read_stem_csv(folder / "new.csv").size() == 2);
}

TEST_CASE("changed stem CSV: what read_stem_csv refuses is refused here, too") {
  const TemporaryFolder folder;
  write_raw(folder / "bad.csv", "x_m,y_m\n1,two\n");
  CHECK_THAT(user_error_of([&] { StemCsvFile file(folder / "bad.csv"); }),
             Catch::Contains("bad.csv:2:3"));
  write_raw(folder / "none.csv", "x_m,y_m\n");
  CHECK_THAT(user_error_of([&] { StemCsvFile file(folder / "none.csv"); }),
             Catch::Contains("no stems"));
}
