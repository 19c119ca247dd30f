#include "page/html/search_text.h"

#include <cmark-gfm.h>
#include <cmark-gfm/node.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "base/running_text.h"
#include "page/html/reader_text.h"

namespace mjcourse {
namespace {

class Reader {
 public:
  Reader(const Lesson& lesson, const LessonResults& results) : lesson_(lesson), results_(results) {}

  std::vector<SearchSection> sections() {
    read(lesson_.front.summary);
    for (const Document& objective : lesson_.front.objectives) read(objective);
    read(lesson_.document);
    for (SearchSection& section : sections_) {
      section.text = with_single_blanks(section.text);
      section.code = with_single_blanks(section.code);
    }
    return std::move(sections_);
  }

  // What each kind of block says.
  void operator()(const Math& math) {
    if (!math.display) say(text_of_formula(results_.get<FormulaResult>(block_), math.tex.text));
  }
  void operator()(const InlineValue& value) {
    const auto* result = results_.get<ValueResult>(block_);
    say(result != nullptr ? result->text : value.expression.text);
  }
  void operator()(const TermUse&) { read_children(node_); }
  void operator()(const Example& example) { show_program(example.code.text); }
  void operator()(const Exercise&) {
    if (const auto* result = results_.get<ExerciseResult>(block_)) {
      for (const Check& check : result->checks) say(check.what + ". ");
    }
  }
  void operator()(const Unchecked& unchecked) { show(unchecked.code.text); }
  void operator()(const Snippet& snippet) {
    show(snippet.shown);
    if (const auto* result = results_.get<ExampleResult>(block_)) show(result->output);
  }
  void operator()(const Commands& commands) { show(commands.code.text); }
  void operator()(const ModelExcerpt& excerpt) { show(excerpt.text.text); }
  void operator()(const InlineModel& model) {
    show(model.text.text);
    if (const auto* result = results_.get<ModelResult>(block_)) show(result->refusal);
  }
  void operator()(const Output& output) {
    if (output.apart) show(output.text.text);
  }
  void operator()(const Image& image) { say(image.alt + " "); }
  void operator()(const Io& io) {
    for (const Io::Row& row : io.rows) {
      say(row.label + " ");
      read(row.text);
    }
  }
  void operator()(const Callout& callout) {
    cmark_node* const node = node_;
    read(callout.title);
    read_children(node);
  }
  void operator()(const Lab& lab) {
    say(lab.title + " " + lab.alt + " ");
    for (const Lab::Control& control : lab.controls) {
      say(std::visit([](const auto& one) { return one.label.text; }, control) + " ");
    }
    for (const Lab::Readout& readout : lab.readouts) say(readout.label.text + " ");
    read(lab.note);
  }
  void operator()(const Figure& figure) {
    say(figure.alt + " ");
    read(figure.caption);
  }
  void operator()(const Plot& plot) {
    say(plot.alt + " ");
    read(plot.caption);
  }
  void operator()(const Quiz& quiz) {
    say(quiz.title + " ");
    for (const Question& question : quiz.questions) {
      read(question.text);
      for (const Option& option : question.options) read(option.text);
    }
  }
  void operator()(const Demo& demo) { show(demo.source); }
  void operator()(const Shown&) {}

 private:
  void say(const std::string& words) { sections_.back().text += words; }
  void show(const std::string& code) { sections_.back().code += code + " "; }

  // As a reader sees it, with what it prints.
  void show_program(const std::string& code) {
    const auto* result = results_.get<ExampleResult>(block_);
    show(result != nullptr ? result->code : code);
    if (result != nullptr) show(result->output);
  }

  void read(const Document& document) {
    if (document == nullptr) return;
    read(document.get());
    say(" ");
  }

  void read_children(cmark_node* node) {
    for (cmark_node* child = cmark_node_first_child(node); child != nullptr;
         child = cmark_node_next(child)) {
      read(child);
    }
  }

  void read(cmark_node* node) {
    if (const auto found = lesson_.block_of.find(node); found != lesson_.block_of.end()) {
      block_ = found->second;
      node_ = node;
      std::visit(*this, lesson_.blocks[block_]);
    } else if (cmark_node_get_type(node) == CMARK_NODE_HEADING) {
      begin_section(node);
      return;
    } else if (cmark_node_get_type(node) == CMARK_NODE_CODE_BLOCK) {
      show(cmark_node_get_literal(node));
    } else if (cmark_node_first_child(node) == nullptr) {
      say(plain_text(node));
    } else {
      read_children(node);
    }
    if (CMARK_NODE_BLOCK_P(node)) say(" ");
  }

  void begin_section(cmark_node* node) {
    const auto heading = std::find_if(lesson_.headings.begin(), lesson_.headings.end(),
                                      [&](const Heading& one) { return one.node == node; });
    const std::string title = reader_text(node, lesson_, results_);
    if (heading == lesson_.headings.end()) return say(title + " ");
    sections_.push_back({title, heading->id, {}, {}});
  }

  const Lesson& lesson_;
  const LessonResults& results_;
  std::vector<SearchSection> sections_{1};
  std::size_t block_ = 0;       // the block that is being read,
  cmark_node* node_ = nullptr;  // and its node
};

}  // namespace

std::vector<SearchSection> search_sections(const Lesson& lesson, const LessonResults& results) {
  return Reader(lesson, results).sections();
}

}  // namespace mjcourse
