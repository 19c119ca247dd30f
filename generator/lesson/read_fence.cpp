// What a fence's first word means, and the kinds that are a few lines to read.
#include <string_view>

#include "base/nearest.h"
#include "lesson/fence.h"
#include "lesson/lesson_reader.h"
#include "lesson/read_chart.h"
#include "lesson/read_code.h"
#include "lesson/read_lab.h"
#include "lesson/read_model_fence.h"
#include "lesson/read_quiz.h"

namespace mjcourse {
namespace {

std::string word(const Fence& fence, std::size_t index) {
  return index < fence.words().size() ? fence.words()[index].text : "";
}

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
      reader.reading().error(
          "E-io-label", body.span(at, end),
          "an `io` panel is made of lines `INPUT: …`, `PROCESS: …`, `OUTPUT: …`");
      return std::nullopt;
    }
    rows.back().second.append_line({body.text.substr(from, end - from),
                                    {body.offsets.begin() + static_cast<std::ptrdiff_t>(from),
                                     body.offsets.begin() + static_cast<std::ptrdiff_t>(end) + 1}});
    at = end + 1;
  }
  fence.finish("io", reader.reading());
  Io io;
  for (auto& [label, text] : rows) io.rows.push_back({label, reader.fragment(text)});
  return io;
}

void report_unknown(const Fence& fence, Reading& reading) {
  const std::string kind = word(fence, 0);
  if (fence.indented()) {
    reading.error("E-fence-kind", fence.span(), "an indented block is code that nobody ran",
                  "remove the indentation, or use a fence");
  } else if (kind == "figure") {
    reading.error("E-not-yet", fence.words()[0].span(),
                  "a `" + kind +
                      "` fence belongs to the lesson language, but this version of "
                      "mjcourse cannot do it yet",
                  "leave it out for now");
  } else if (kind.empty()) {
    reading.error("E-fence-kind", fence.span(), "this fence does not say what it holds",
                  "known: cpp, xml, text, io, lab, plot, quiz");
  } else {
    reading.error("E-fence-kind", fence.words()[0].span(), "there is no fence `" + kind + "`",
                  suggest(kind, {"cpp", "xml", "text", "io", "lab", "plot", "quiz"}));
  }
}

}  // namespace

void LessonReader::read_fence(cmark_node* node) {
  Fence fence(node, source());
  if (!fence.closed()) {
    reading_.error("E-fence-unclosed", fence.span(), "this fence is never closed",
                   "end it with a line of as many backticks");
    return;
  }
  const std::string kind = word(fence, 0);
  if (kind == "cpp") {
    if (auto code = read_code(fence, reading_)) add(node, std::move(*code));
  } else if (kind == "xml") {
    if (auto model = read_model_fence(fence, reading_)) add(node, std::move(*model));
  } else if (kind == "text") {
    read_output(node, fence);
  } else if (kind == "io") {
    if (auto io = read_io(fence, *this)) add(node, std::move(*io));
  } else if (kind == "lab" && word(fence, 1) == "simlab") {
    if (auto lab = read_lab(fence, *this)) add(node, std::move(*lab));
  } else if (kind == "lab") {
    reading_.error("E-fence-kind", fence.span(), "a lab says of which kind it is",
                   "write `lab simlab`");
  } else if (kind == "plot") {
    if (auto chart = read_chart(fence, *this)) add(node, std::move(*chart));
  } else if (kind == "quiz") {
    if (auto quiz = read_quiz(fence, *this)) {
      refuse_second_quiz(*quiz, fence.span());
      add(node, std::move(*quiz));
    }
  } else {
    report_unknown(fence, reading_);
  }
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

// The code whose output this is: the example named, or the example or snippet just above (a
// paragraph "Output:" may stand between).
void LessonReader::read_output(cmark_node* node, Fence& fence) {
  const auto index_of = [this](cmark_node* at) -> std::optional<std::size_t> {
    const auto found = at != nullptr ? lesson_.block_of.find(at) : lesson_.block_of.end();
    if (found == lesson_.block_of.end()) return std::nullopt;
    const Block& block = lesson_.blocks[found->second];
    const bool prints =
        std::holds_alternative<Example>(block) || std::holds_alternative<Snippet>(block);
    return prints ? std::optional(found->second) : std::nullopt;
  };
  cmark_node* above = cmark_node_previous(node);
  const bool labelled = above != nullptr && plain_text(above) == "Output:";
  std::optional<std::size_t> example;
  if (const auto named = fence.option("output")) {
    example = example_named(*named);
    if (!example) return;
  } else {
    example = index_of(labelled ? cmark_node_previous(above) : above);
  }
  if (!example) {
    reading_.error(
        "E-output-stray", fence.span(), "this output belongs to no program",
        "put it right after a `cpp file=…` or `cpp snippet` fence, or name the example above: "
        "`text output=NAME`");
    return;
  }
  const std::optional<double> tolerance = fence.number("tol", reading_);
  fence.finish("text", reading_);
  Block& printing = lesson_.blocks[*example];
  if (auto* snippet = std::get_if<Snippet>(&printing)) {
    snippet->output = lesson_.blocks.size();
  } else {
    std::get<Example>(printing).output = lesson_.blocks.size();
  }
  add(node, Output{fence.body(), tolerance, *example, fence.span()});
  if (labelled) add(above, Shown{});
}

}  // namespace mjcourse
