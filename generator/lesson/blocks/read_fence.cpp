// What a fence's first word means, and which program an output belongs to.
// Tested by tests/generator/lesson/output_test.cpp.
// Tested by tests/generator/lesson/blocks/read_demo_test.cpp.
#include <algorithm>
#include <string_view>
#include <utility>

#include "base/nearest.h"
#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson_reader.h"
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

std::string word(const Fence& fence, std::size_t index) {
  return index < fence.words().size() ? fence.words()[index].text : "";
}

// Where a block that prints keeps who states what; null for another block.
std::vector<std::size_t>* outputs_of(Block& block) {
  if (auto* example = std::get_if<Example>(&block)) return &example->outputs;
  if (auto* snippet = std::get_if<Snippet>(&block)) return &snippet->outputs;
  if (auto* commands = std::get_if<Commands>(&block)) return &commands->outputs;
  return nullptr;
}

void report_unknown(const Fence& fence, Reading& reading) {
  const std::string kind = word(fence, 0);
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

}  // namespace

void LessonReader::read_fence(cmark_node* node, Region& region) {
  Fence fence(node, source());
  const std::string kind = word(fence, 0);
  if (!fence.closed()) {
    reading_.error("E-fence-unclosed", fence.span(), "this fence is never closed",
                   kind == "demo" ? "begin and end a demo with more backticks than any fence in it"
                                  : "end it with a line of as many backticks");
    return;
  }
  const std::vector<std::string>& shown = unchecked_languages();
  const bool only_shown = std::find(shown.begin(), shown.end(), kind) != shown.end();
  if (is_unchecked(fence) && find_fence_kind(kind + " unchecked") != nullptr) {
    add(node, read_unchecked(fence, reading_));
  } else if (is_commands(fence)) {
    add(node, read_commands(fence, reading_));
  } else if (only_shown) {
    refuse_plain(fence, reading_);
  } else if (kind == "cpp") {
    if (auto code = read_code(fence, reading_)) add(node, std::move(*code));
  } else if (kind == "xml") {
    if (auto model = read_model_fence(fence, reading_)) add(node, std::move(*model));
  } else if (kind == "text") {
    read_output(node, fence);
  } else if (kind == "io") {
    if (auto io = read_io(fence, *this)) add(node, std::move(*io));
  } else if (kind == "lab" && word(fence, 1) == "simlab") {
    if (auto lab = read_lab(fence, *this)) {
      refuse_second_pin(lab->pin);
      add(node, std::move(*lab));
    }
  } else if (kind == "lab") {
    if (!fence.refuse_second_word({"simlab"}, reading_)) {
      reading_.error("E-fence-kind", fence.span(), "a lab says of which kind it is",
                     "write `lab simlab`");
    }
  } else if (kind == "plot") {
    if (auto plot = read_plot(fence, *this)) add(node, std::move(*plot));
  } else if (kind == "quiz") {
    if (auto quiz = read_quiz(fence, *this)) {
      refuse_second_quiz(*quiz, fence.span());
      add(node, std::move(*quiz));
    }
  } else if (kind == "figure") {
    if (auto figure = read_figure(fence, *this)) {
      refuse_second_pin(figure->pin);
      add(node, std::move(*figure));
    }
  } else if (kind == "demo") {
    read_demo(node, fence, region);
  } else {
    report_unknown(fence, reading_);
  }
}

// ````demo: a piece of a lesson as it is written, and below it what it becomes.
//
// What stands in a demo is a part of its lesson like any other: its programs are run, its labs
// rehearsed, its answers proved. So a guide for authors that is made of demos cannot say what is
// no longer so.
//
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

// The block of the example `name` above; nothing (reported) when there is none.
std::optional<std::size_t> LessonReader::example_named(const LocatedText& name) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < lesson_.blocks.size(); ++i) {
    const auto* example = std::get_if<Example>(&lesson_.blocks[i]);
    if (example == nullptr) continue;
    if (example->name() == name.text) return i;
    known.push_back(example->name());
  }
  reading_.error("E-output-stray", name.span(), "there is no example `" + name.text + "` above",
                 known.empty() ? "write its `cpp file=…` fence first" : suggest(name.text, known));
  return std::nullopt;
}

// The page and what a reader's browser remembers tell quizzes apart by their ids.
void LessonReader::refuse_second_quiz(const Quiz& quiz, Span span) {
  for (const Block& block : lesson_.blocks) {
    const auto* other = std::get_if<Quiz>(&block);
    if (other == nullptr || other->id != quiz.id) continue;
    reading_.error("E-quiz-id", span, "another quiz of this lesson has the id \"" + quiz.id + "\"",
                   "give each quiz an id of its own");
  }
}

// A lesson's reference pictures are told apart by their names; a second of one name is left out.
void LessonReader::refuse_second_pin(LocatedText& pin) {
  for (const Block& block : lesson_.blocks) {
    if (pin.text.empty() || pin_of(block).text != pin.text) continue;
    reading_.error("E-pin-name", pin.span(),
                   "another picture of this lesson is pinned as \"" + pin.text + "\"",
                   "give each a name of its own");
    pin = {};
  }
}

// The code whose output this is: the example named, or the example, snippet or commands just above
// (a paragraph "Output:" may stand between).
void LessonReader::read_output(cmark_node* node, Fence& fence) {
  const auto index_of = [this](cmark_node* at) -> std::optional<std::size_t> {
    const auto found = at != nullptr ? lesson_.block_of.find(at) : lesson_.block_of.end();
    if (found == lesson_.block_of.end()) return std::nullopt;
    const bool prints = outputs_of(lesson_.blocks[found->second]) != nullptr;
    return prints ? std::optional(found->second) : std::nullopt;
  };
  cmark_node* above = cmark_node_previous(node);
  const bool labelled = above != nullptr && plain_text(above) == "Output:";
  const std::optional<std::size_t> just_above =
      index_of(labelled ? cmark_node_previous(above) : above);
  std::optional<std::size_t> example = just_above;
  if (const auto named = fence.option("output")) {
    example = example_named(*named);
    if (!example) return;
  }
  if (!example) {
    reading_.error(
        "E-output-stray", fence.span(), "this output belongs to no program",
        "put it right after a `cpp file=…`, `cpp snippet` or `sh run` fence, or name the example "
        "above: `text output=NAME`");
    return;
  }
  const std::optional<double> tolerance = fence.number("tol", reading_);
  fence.finish("text", fences::kOutput, reading_);
  outputs_of(lesson_.blocks[*example])->push_back(lesson_.blocks.size());
  const Block* block_above = above != nullptr ? lesson_.block(above) : nullptr;
  const auto* other = block_above != nullptr ? std::get_if<Output>(block_above) : nullptr;
  const bool below_another = other != nullptr && other->example == example && !other->apart;
  add(node, Output{fence.body(), tolerance, *example, fence.span(),
                   example != just_above && !below_another});
  if (labelled) add(above, Shown{});
}

}  // namespace mjcourse
