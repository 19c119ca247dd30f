#include "lesson/blocks/read_demo.h"

#include <string>

namespace mjcourse {

bool check_demo(const Fence& fence, bool in_demo, Reading& reading) {
  fence.finish("demo", {}, reading);
  const auto refuse = [&](const char* id, const char* message, const char* cure) {
    reading.error(id, fence.span(), message, cure);
    return false;
  };
  if (in_demo) {
    return refuse("E-demo-nested", "a demo cannot stand in a demo",
                  "put the two one after the other");
  }
  const SourceText& source = reading.source();
  const std::size_t start = fence.span().begin;
  if (start != source.line_start(source.position(start).line)) {
    return refuse("E-demo-indented", "a demo begins at the very start of its line",
                  "take it out of the list or the quote, or remove its indentation");
  }
  if (fence.body().text.find_first_not_of(" \t\n") == std::string::npos) {
    return refuse("E-demo-empty", "this demo shows nothing", "put a piece of a lesson into it");
  }
  return true;
}

}  // namespace mjcourse
