#include "lesson/blocks/read_fence.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/nearest.h"
#include "lesson/blocks/read_code.h"
#include "lesson/blocks/read_commands.h"
#include "lesson/blocks/read_figure.h"
#include "lesson/blocks/read_io.h"
#include "lesson/blocks/read_lab.h"
#include "lesson/blocks/read_model_fence.h"
#include "lesson/blocks/read_plot.h"
#include "lesson/blocks/read_quiz.h"
#include "lesson/blocks/read_unchecked.h"
#include "lesson/blocks/read_view.h"

namespace mjcourse {
namespace {

void report_unknown(const Fence& fence, Reading& reading) {
  const std::string kind = fence.kind();
  std::vector<std::string> known;
  for (const FenceKind& one : fence_kinds()) {
    const std::string first = one.words.substr(0, one.words.find(' '));
    if (std::ranges::count(known, first) == 0) known.push_back(first);
  }
  if (fence.indented()) {
    reading.error("E-fence-kind", fence.span(), "an indented block is code that nobody ran",
                  "remove the indentation, or use a fence");
  } else if (kind.empty()) {
    reading.error("E-fence-kind", fence.span(), "this fence does not say what it holds",
                  suggest(kind, known));
  } else {
    reading.error("E-fence-kind", fence.words()[0].span(), "there is no fence `" + kind + "`",
                  suggest(kind, known));
  }
}

// The page and what a reader's browser remembers tell quizzes apart by their ids.
void refuse_second_quiz(const Quiz& quiz, Span span, const Lesson& lesson, Reading& reading) {
  for (const Block& block : lesson.blocks) {
    const auto* other = std::get_if<Quiz>(&block);
    if (other == nullptr || other->id != quiz.id) continue;
    reading.error("E-quiz-id", span, "another quiz of this lesson has the id \"" + quiz.id + "\"",
                  "give each quiz an id of its own");
  }
}

// A lesson's reference pictures are told apart by their names; a second of one name is left out.
void refuse_second_pin(LocatedText& pin, const Lesson& lesson, Reading& reading) {
  for (const Block& block : lesson.blocks) {
    if (pin.text.empty() || pin_of(block).text != pin.text) continue;
    reading.error("E-pin-name", pin.span(),
                  "another picture of this lesson is pinned as \"" + pin.text + "\"",
                  "give each a name of its own");
    pin = {};
  }
}

std::optional<Lab> read_lab_fence(Fence& fence, LessonReader& reader) {
  if (fence.words().size() > 1 && fence.words()[1].text == "simlab") {
    std::optional<Lab> lab = read_lab(fence, reader);
    if (lab) refuse_second_pin(lab->pin, reader.lesson(), reader.reading());
    return lab;
  }
  if (!fence.refuse_second_word({"simlab"}, reader.reading())) {
    reader.reading().error("E-fence-kind", fence.span(), "a lab says of which kind it is",
                           "write `lab simlab`");
  }
  return std::nullopt;
}

std::optional<Quiz> read_quiz_fence(Fence& fence, LessonReader& reader) {
  std::optional<Quiz> quiz = read_quiz(fence, reader);
  if (quiz) refuse_second_quiz(*quiz, fence.span(), reader.lesson(), reader.reading());
  return quiz;
}

std::optional<Figure> read_figure_fence(Fence& fence, LessonReader& reader) {
  std::optional<Figure> figure = read_figure(fence, reader);
  if (figure) refuse_second_pin(figure->pin, reader.lesson(), reader.reading());
  return figure;
}

// A std::optional<Kind> converts to no std::optional<Block>, since a block cannot be copied.
template <typename Kind>
std::optional<Block> as_block(std::optional<Kind> read) {
  return read ? std::optional<Block>(*std::move(read)) : std::nullopt;
}

}  // namespace

bool refuse_unclosed(const Fence& fence, Reading& reading) {
  if (fence.closed()) return false;
  reading.error("E-fence-unclosed", fence.span(), "this fence is never closed",
                fence.kind() == "demo"
                    ? "begin and end a demo with more backticks than any fence in it"
                    : "end it with a line of as many backticks");
  return true;
}

std::optional<Block> read_fence(Fence& fence, LessonReader& reader) {
  Reading& reading = reader.reading();
  const std::string kind = fence.kind();
  if (is_unchecked(fence) && find_fence_kind(kind + " unchecked") != nullptr) {
    return read_unchecked(fence, reading);
  }
  if (is_commands(fence)) return read_commands(fence, reading);
  if (std::ranges::count(unchecked_languages(), kind) > 0) {
    refuse_plain(fence, reading);
    return std::nullopt;
  }
  if (kind == "cpp") return read_code(fence, reading);
  if (kind == "xml") return read_model_fence(fence, reading);
  if (kind == "io") return as_block(read_io(fence, reader));
  if (kind == "lab") return as_block(read_lab_fence(fence, reader));
  if (kind == "plot") return as_block(read_plot(fence, reader));
  if (kind == "quiz") return as_block(read_quiz_fence(fence, reader));
  if (kind == "figure") return as_block(read_figure_fence(fence, reader));
  report_unknown(fence, reading);
  return std::nullopt;
}

}  // namespace mjcourse
