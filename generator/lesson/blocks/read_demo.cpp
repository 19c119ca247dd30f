// ````demo: a piece of a lesson as it is written, and below it what it becomes.
//
// What stands in a demo is a part of its lesson like any other: its programs are run, its labs
// rehearsed, its answers proved. So a guide for authors that is made of demos cannot say what is
// no longer so.
#include <utility>

#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

// cmark's line numbers are the lesson's own, so the walk places what it finds as it does everywhere
// else.
void LessonReader::read_demo(cmark_node* node, Fence& fence, Region& region) {
  fence.finish("demo", {}, reading_);
  const std::size_t start = fence.span().begin;
  const int line = source().position(start).line;
  const auto refuse = [&](const char* id, const char* message, const char* cure) {
    reading_.error(id, fence.span(), message, cure);
  };
  if (in_demo_) {
    return refuse("E-demo-nested", "a demo cannot stand in a demo",
                  "put the two one after the other");
  }
  if (start != source().line_start(line)) {
    return refuse("E-demo-indented", "a demo begins at the very start of its line",
                  "take it out of the list or the quote, or remove its indentation");
  }
  const std::string& text = fence.body().text;
  if (text.find_first_not_of(" \t\n") == std::string::npos) {
    return refuse("E-demo-empty", "this demo shows nothing", "put a piece of a lesson into it");
  }
  Document document = parse(text, line + 1);
  in_demo_ = true;
  walk(document.get(), region);
  in_demo_ = false;
  add(node, Demo{text, std::move(document)});
}

}  // namespace mjcourse
