// The tables of the author guide, to hold them against the lists that the code reads by.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"

namespace mjcourse {

// What stands in backticks in `cell`.
inline std::vector<std::string> code_in(const std::string& cell) {
  std::vector<std::string> names;
  for (std::size_t at = 0; (at = cell.find('`', at)) != cell.npos;) {
    const std::size_t end = cell.find('`', at + 1);
    if (end == cell.npos) break;
    names.push_back(cell.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return names;
}

struct GuideRow {
  std::vector<std::string> names;  // in the first cell
  std::string words;               // of the others
};

// The rows of the table that begins with the line `head`, below `above`, in `page` of the guide.
inline std::vector<GuideRow> guide_table(const std::string& page, const std::string& head,
                                         const std::string& above = "") {
  const DiskFiles guide(std::filesystem::path(MJCOURSE_ROOT) / "content/guide");
  const std::string text = guide.read(page).value();
  std::vector<GuideRow> rows;
  std::size_t at = text.find(above);
  if (at != text.npos) at = text.find("\n" + head + "\n", at);
  if (at == text.npos) return rows;
  at = text.find('\n', at + 1) + 1;  // the row of dashes
  while (text[at = text.find('\n', at) + 1] == '|') {
    const std::string row = text.substr(at, text.find('\n', at) - at);
    const std::size_t bar = row.find('|', 1);
    rows.push_back({code_in(row.substr(0, bar)), row.substr(bar)});
  }
  return rows;
}

// All names of the first column, sorted.
inline std::vector<std::string> names_of(const std::vector<GuideRow>& rows) {
  std::vector<std::string> names;
  for (const GuideRow& row : rows) names.insert(names.end(), row.names.begin(), row.names.end());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace mjcourse
