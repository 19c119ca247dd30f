// A row of a table as GFM cuts it: at each bar that no backslash precedes, whatever it stands in.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// Where a row's cells begin and end.
struct RowCell {
  std::size_t begin, end;
};
std::vector<RowCell> cells_of_row(std::string_view row);

// The first bar that ends a cell within a formula or a piece of code.
struct CuttingBar {
  std::size_t at;
  const char* within;  // "a formula"
};
std::optional<CuttingBar> cutting_bar(std::string_view row);

}  // namespace mjcourse
