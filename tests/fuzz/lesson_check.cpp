#include "lesson_check.h"

#include <set>

#include "diagnostic_check.h"
#include "lesson/read_lesson.h"
#include "located_pieces.h"
#include "require.h"

namespace mjcourse {
namespace {

void check_text(const LocatedText& text, const SourceText& source, const std::string& what) {
  if (text.offsets.empty()) return;  // it stands nowhere
  require(text.offsets.size() == text.text.size() + 1, what + ": a place for each byte");
  for (std::size_t i = 0; i < text.offsets.size(); ++i) {
    require(text.offsets[i] <= source.text().size(), what + ": in the file");
  }
}

// Each byte is the one that stands there, but for the ends of lines and for tabs, which cmark makes
// spaces where a part of one belongs to a list.
void check_body(const LocatedText& body, const SourceText& source) {
  for (std::size_t i = 0; i < body.text.size(); ++i) {
    if (body.offsets.empty()) return;
    const char c = body.text[i];
    if (c == '\n' || c == ' ') continue;
    const std::size_t at = body.offsets[i];
    require(at < source.text().size() && source.text()[at] == c,
            "byte " + std::to_string(i) + " of a fence is its lesson's");
  }
}

void check_block(const Block& block, const Lesson& lesson) {
  const SourceText& source = *lesson.source;
  const std::string what = "block of kind " + std::to_string(block.index());
  const LocatedPieces pieces = pieces_of(block);
  for (const LocatedText* text : pieces.texts) check_text(*text, source, what);
  for (const LocatedText* body : pieces.bodies) check_body(*body, source);
  for (const Span span : pieces.spans) {
    require(span.begin <= span.end && span.end <= source.text().size(), what + ": its span");
  }
}

// An output and its program know of one another.
void check_outputs(const Lesson& lesson) {
  const auto check_printing = [&](const auto* printing, std::size_t index) {
    if (printing == nullptr) return;
    for (const std::size_t output : printing->outputs) {
      require(output > index && output < lesson.blocks.size(), "an output is below its program");
      const auto* of = std::get_if<Output>(&lesson.blocks[output]);
      require(of != nullptr && of->example == index, "it is an output of this program");
    }
  };
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    check_printing(std::get_if<Example>(&lesson.blocks[i]), i);
    check_printing(std::get_if<Snippet>(&lesson.blocks[i]), i);
  }
}

}  // namespace

void check_lesson(const Lesson& lesson) {
  for (const Block& block : lesson.blocks) check_block(block, lesson);
  check_outputs(lesson);
  for (const auto& [node, index] : lesson.block_of) {
    require(index < lesson.blocks.size(), "a node stands for a block that is there");
  }
  std::set<std::string> ids;
  for (const Heading& heading : lesson.headings) {
    require(!heading.id.empty() && ids.insert(heading.id).second, "a heading has an id of its own");
  }
  for (const Link& link : lesson.links) check_text(link.target, *lesson.source, "a link");
  check_text(lesson.front.title, *lesson.source, "the title");
  for (const LocatedText& number : lesson.front.prerequisites) {
    check_text(number, *lesson.source, "a prerequisite");
  }
}

std::string text_of(const Lesson& lesson) {
  std::string text = lesson.front.title.text;
  const auto add = [&](const LocatedText& piece) {
    text += piece.text;
    for (std::size_t i = 0; i < piece.offsets.size(); ++i) {
      text += " " + std::to_string(piece.offsets[i]);
    }
    text += "\n";
  };
  for (const Block& block : lesson.blocks) {
    text += std::to_string(block.index()) + "\n";
    for (const LocatedText* piece : pieces_of(block).texts) add(*piece);
  }
  for (const Heading& heading : lesson.headings) text += heading.id + "\n";
  for (const Link& link : lesson.links) add(link.target);
  return text;
}

void check_reading(const std::string& path, const std::string& bytes) {
  Diagnostics diagnostics, again;
  const std::optional<Lesson> lesson = read_lesson(path, bytes, diagnostics);
  check_diagnostics(diagnostics, {{path, SourceText(path, bytes)}});
  require(lesson || !diagnostics.empty(), "a lesson that cannot be read is a mistake");
  if (lesson) check_lesson(*lesson);
  const std::optional<Lesson> second = read_lesson(path, bytes, again);
  require(text_of(diagnostics) == text_of(again), "a second reading finds the same mistakes");
  require(!lesson || text_of(*lesson) == text_of(second.value()), "and the same lesson");
}

}  // namespace mjcourse
