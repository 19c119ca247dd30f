#include "findings/snippet_program.h"

#include <string>
#include <variant>

#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr const char* kFolder = "snippets/";

}  // namespace

Example snippet_program(const Lesson& lesson, std::size_t block) {
  const auto& snippet = std::get<Snippet>(lesson.blocks[block]);
  std::string number = lesson.number.empty() ? "glossary" : lesson.number;
  for (char& c : number) {
    if (!is_word_character(c)) c = '_';
  }
  Example program;
  program.file.text =
      kFolder + ("snippet_" + number) + "_" + std::to_string(block_number(lesson, block)) + ".cpp";
  program.seconds = snippet.seconds;
  program.native = snippet.native;
  program.span = snippet.span;
  program.outputs = snippet.outputs;
  program.quoted = false;
  return program;
}

bool is_snippet_program(const Example& program) {
  return program.file.text.starts_with(kFolder);
}

}  // namespace mjcourse
