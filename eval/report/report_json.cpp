#include "eval/report/report_json.h"

namespace honka::eval {
namespace {

/// A cell is a text, or {ours, paper, difference} where the paper has a figure.
Json cell_json(const ReportCell& cell) {
  if (cell.paper.empty() && cell.difference.empty()) return cell.text;
  return {{"ours", cell.text}, {"paper", cell.paper}, {"difference", cell.difference}};
}

ReportCell cell_from(const Json& json) {
  if (json.is_string()) return {json.get<std::string>()};
  return {json.at("ours"), json.at("paper"), json.at("difference")};
}

Json table_json(const ReportTable& table) {
  Json headers = Json::array(), rows = Json::array();
  for (const ReportHeader& header : table.headers) {
    headers.push_back({{"name", header.name}, {"unit", header.unit}});
  }
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const ReportCell& cell : row) cells.push_back(cell_json(cell));
    rows.push_back(std::move(cells));
  }
  return {{"title", table.title},
          {"protocol", table.protocol},
          {"headers", headers},
          {"rows", rows},
          {"notes", table.notes}};
}

ReportTable table_from(const Json& json) {
  ReportTable table;
  table.title = json.at("title");
  table.protocol = json.at("protocol");
  table.notes = json.at("notes").get<std::vector<std::string>>();
  for (const Json& header : json.at("headers")) {
    table.headers.push_back({header.at("name"), header.at("unit")});
  }
  for (const Json& row : json.at("rows")) {
    std::vector<ReportCell>& cells = table.rows.emplace_back();
    for (const Json& cell : row) cells.push_back(cell_from(cell));
  }
  return table;
}

}  // namespace

Json to_json(const ReportModel& model) {
  Json tables = Json::array(), figures = Json::array();
  for (const ReportTable& table : model.tables) tables.push_back(table_json(table));
  for (const ReportFigure& figure : model.figures) {
    figures.push_back({{"file", figure.file},
                       {"title", figure.title},
                       {"caption", figure.caption},
                       {"notice", figure.notice}});
  }
  return {{"title", model.title},
          {"question", model.question},
          {"lead_notes", model.lead_notes},
          {"tables", tables},
          {"figures", figures},
          {"protocol", model.protocol},
          {"scenario_text", model.scenario_text},
          {"reproduce", model.reproduce}};
}

ReportModel report_from_json(const Json& json) {
  ReportModel model;
  model.title = json.at("title");
  model.question = json.at("question");
  model.lead_notes = json.at("lead_notes").get<std::vector<std::string>>();
  model.protocol = json.at("protocol").get<std::vector<std::string>>();
  model.scenario_text = json.at("scenario_text");
  model.reproduce = json.at("reproduce");
  for (const Json& table : json.at("tables")) model.tables.push_back(table_from(table));
  for (const Json& figure : json.at("figures")) {
    model.figures.push_back(
        {figure.at("file"), figure.at("title"), figure.at("caption"), figure.at("notice")});
  }
  return model;
}

}  // namespace honka::eval
