// A list in brackets, `[a, b]`, as it stands in a YAML file: on one line, or an item a line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

// `text` with `item` as the item `index` of the list whose `[` is at `open` and whose items begin
// at `items`; nothing where there is no such list.
std::optional<std::string> insert_into_flow_list(const std::string& text, std::size_t open,
                                                 const std::vector<std::size_t>& items,
                                                 std::size_t index, const std::string& item);

}  // namespace mjcourse
