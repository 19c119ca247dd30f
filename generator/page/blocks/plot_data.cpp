#include "page/blocks/plot_data.h"

#include <cstdio>
#include <string>

#include "page/html/site_paths.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr std::size_t kMostRows = 12;  // more of them are only to be downloaded

json drawing_data(const PlotDrawing& drawing) {
  return {{"svg", drawing.svg}, {"width", drawing.width}, {"height", drawing.height}};
}

// To six digits, with a minus that is one.
std::string in_cell(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", value == 0 ? 0 : value);
  std::string text;
  for (const char* c = digits; *c != '\0'; ++c) text += *c == '-' ? "\u2212" : std::string(1, *c);
  return text;
}

json rows_of(const Table& table) {
  json rows = json::array();
  const std::size_t count = table.front().values.size();
  for (std::size_t row = 0; row < count && count <= kMostRows; ++row) {
    json cells = json::array();
    for (const Column& column : table) cells.push_back(in_cell(column.values[row]));
    rows.push_back(std::move(cells));
  }
  return rows;
}

}  // namespace

json plot_data(const Plot& plot, std::size_t index, const LessonContext& context) {
  json data{{"id", block_name(context.lesson, index)},
            {"alt", plot.alt},
            {"caption", context.inline_html(plot.caption)},
            {"wide", nullptr},
            {"narrow", nullptr}};
  const auto* result = context.results.get<PlotResult>(index);
  if (result == nullptr) return data;
  const PlotDrawings& drawings = result->drawings;
  data["wide"] = drawing_data(drawings.wide);
  if (drawings.narrow) data["narrow"] = drawing_data(*drawings.narrow);
  data["program"] = {{"name", plot.example.text + ".cpp"},
                     {"quotes", plot.example.text},
                     {"href", "../" + site_address(result->file)}};
  const std::string address = "../" + site_address(block_path(context.lesson, index));
  data["spec"] = address + ".json";
  json columns = json::array();
  for (const Column& column : result->table) columns.push_back(column.name);
  data["table"] = {{"name", plot.table.text},
                   {"columns", std::move(columns)},
                   {"rows", rows_of(result->table)},
                   {"count", result->table.front().values.size()},
                   {"href", address + ".csv"}};
  return data;
}

}  // namespace mjcourse
