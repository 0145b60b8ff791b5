#include <algorithm>

#include "algo/types/user_error.h"
#include "eval/io/hdf5.h"
#include "eval/io/safe_file.h"
#include "eval/io/table.h"

namespace honka::eval {
namespace {

void write_table(H5File& file, const std::string& group, const Table& table) {
  file.create_group(group);
  for (const Column& column : table.columns()) {
    const std::string name = group + "/" + column.name;
    if (const auto* texts = std::get_if<std::vector<std::string>>(&column.values)) {
      file.write_strings(name, *texts);
    } else if (const auto* doubles = std::get_if<std::vector<double>>(&column.values)) {
      file.write<double>(name, *doubles);
    } else {
      file.write<std::int64_t>(name, std::get<std::vector<std::int64_t>>(column.values));
    }
    file.set_attribute(name, "units", column.unit);
    file.set_attribute(name, "long_name", column.long_name);
    file.set_attribute(name, "in_digest", std::int64_t{column.in_digest});
    if (!column.frame.empty()) file.set_attribute(name, "frame", column.frame);
  }
}

Column read_column(const H5File& file, const std::string& group, const std::string& member) {
  const std::string name = group + "/" + member;
  Column column{
      member, file.string_attribute(name, "units"), file.string_attribute(name, "long_name"), {}};
  column.in_digest = file.int_attribute(name, "in_digest") != 0;
  if (file.has_attribute(name, "frame")) column.frame = file.string_attribute(name, "frame");
  switch (file.kind(name)) {
    case H5File::Kind::kString:
      column.values = file.read_strings(name);
      break;
    case H5File::Kind::kInteger:
      column.values = file.open_column<std::int64_t>(name).read_all();
      break;
    default:
      column.values = file.open_column<double>(name).read_all();
      break;
  }
  return column;
}

}  // namespace

void write_trials_h5(const std::filesystem::path& path,
                     const std::map<std::string, std::string>& context, const Table& trials,
                     const Table& frames) {
  StagedFile staged(path);
  H5File file = H5File::create(staged.temporary());
  file.create_group("/context");
  for (const auto& [key, value] : context) file.set_attribute("/context", key, value);
  write_table(file, "/trials", trials);
  write_table(file, "/frames", frames);
  file.close();
  staged.commit();
}

Table read_table(const std::filesystem::path& path, const std::string& group) {
  const H5File file = H5File::open(path);
  const std::string name = "/" + group;
  if (!file.exists(name)) {
    throw UserError(path.string() + ": no group " + name + "; give a trials.h5 that honka wrote");
  }
  Table table;
  for (const std::string& member : file.members(name)) {
    Column column = read_column(file, name, member);
    const std::size_t rows =
        std::visit([](const auto& values) { return values.size(); }, column.values);
    if (!table.columns().empty() && rows != table.rows()) {
      throw UserError(path.string() + ": columns of " + name +
                      " differ in length; the file is damaged, make it again");
    }
    table.add_column(std::move(column));
  }
  return table;
}

std::map<std::string, std::string> read_context_h5(const std::filesystem::path& path) {
  const H5File file = H5File::open(path);
  std::map<std::string, std::string> context;
  if (!file.exists("/context")) return context;
  for (const std::string& name : file.attributes("/context")) {
    context[name] = file.string_attribute("/context", name);
  }
  return context;
}

}  // namespace honka::eval
