#include "lesson/blocks/read_io.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace mjcourse {

// "INPUT: …" lines; a line without a label goes on with the row above it.
std::optional<Io> read_io(Fence& fence, LessonReader& reader) {
  std::vector<std::pair<std::string, LocatedText>> rows;
  const LocatedText& body = fence.body();
  for (std::size_t at = 0; at < body.text.size();) {
    const std::size_t end = std::min(body.text.find('\n', at), body.text.size());
    std::size_t from = at;
    for (const char* label : {"INPUT", "PROCESS", "OUTPUT"}) {
      const std::string start = std::string(label) + ":";
      if (body.text.compare(at, start.size(), start) != 0) continue;
      rows.emplace_back(label, LocatedText{});
      from = std::min(body.text.find_first_not_of(' ', at + start.size()), end);
    }
    if (rows.empty()) {
      reader.reading().error("E-io-label", body.span(at, end),
                             "this line has none of the labels of an `io` panel",
                             "begin it with `INPUT:`, `PROCESS:` or `OUTPUT:`");
      return std::nullopt;
    }
    rows.back().second.append_line(body.part(from, end));
    at = end + 1;
  }
  fence.finish("io", {}, reader.reading());
  if (rows.empty()) {
    reader.reading().error("E-io-label", fence.span(), "this panel shows nothing",
                           "write lines `INPUT: …`, `PROCESS: …`, `OUTPUT: …` into it");
    return std::nullopt;
  }
  Io io;
  for (auto& [label, text] : rows) io.rows.push_back({label, reader.fragment(text)});
  return io;
}

}  // namespace mjcourse
