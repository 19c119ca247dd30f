#include "page/html/csv.h"

#include <charconv>

namespace mjcourse {
namespace {

std::string exact(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_of(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.size(); ++i)
    text += (i > 0 ? "," : "") + csv_field(table[i].name);
  text += "\r\n";
  const std::size_t rows = table.empty() ? 0 : table.front().values.size();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < table.size(); ++i) {
      text += (i > 0 ? "," : "") + exact(table[i].values[row]);
    }
    text += "\r\n";
  }
  return text;
}

}  // namespace mjcourse
