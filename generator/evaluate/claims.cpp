#include "evaluate/claims.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "evaluate/claim_sources.h"
#include "evaluate/claim_text.h"
#include "evaluate/fence_extent.h"

namespace mjcourse {
namespace {

using Kind = Claim::Kind;
using Status = Claim::Status;
using Programs = std::map<std::string, ExampleResult>;

// Where a region stands for its whole program, because nothing shows that: (lesson, block).
using Stand = std::pair<std::size_t, std::size_t>;
std::set<Stand> stands_of(const Course& course) {
  std::set<std::string> whole;
  std::set<Stand> stands;
  for (const bool regions : {false, true}) {
    for (std::size_t l = 0; l < course.lessons.size(); ++l) {
      for (std::size_t b = 0; b < course.lessons[l].blocks.size(); ++b) {
        const auto* example = std::get_if<Example>(&course.lessons[l].blocks[b]);
        if (example == nullptr || example->region.has_value() != regions) continue;
        const bool is_new = whole.insert(example->file.text).second;
        if (regions && is_new) stands.insert({l, b});
      }
    }
  }
  return stands;
}

std::string text_of(const Records& records) {
  nlohmann::json all = nlohmann::json::object();
  for (const auto& [name, value] : records.results) {
    std::visit([&](const auto& known) { all["results"][name] = known; }, value);
  }
  for (const auto& [name, columns] : records.tables) {
    for (const Column& column : columns) all["tables"][name][column.name] = column.values;
  }
  all["snapshots"] = records.snapshots;
  return all.dump();
}

std::string text_of(const LabResult& result) {
  nlohmann::json all{{"readouts", result.readouts}, {"traces", result.traces}};
  for (const LabRunResult& run : result.runs) {
    nlohmann::json readings = nlohmann::json::array();
    for (const LabReading& reading : run.readings) {
      readings.push_back({reading.steps, reading.values});
    }
    all["runs"].push_back(std::move(readings));
  }
  if (result.predicted) all["predicted"] = *result.predicted;
  return all.dump();
}

// The first line of `code` that says something.
std::string first_line(const std::string& code) {
  const std::size_t begin = std::min(code.find_first_not_of(" \t\n"), code.size());
  return as_title(code.substr(begin, code.find('\n', begin) - begin));
}

// What stands behind "Source:" in the last such paragraph of the callout `index`, and where that
// leads; "" without one.
std::string source_of(const Lesson& lesson, std::size_t index) {
  const auto node = std::find_if(lesson.block_of.begin(), lesson.block_of.end(),
                                 [&](const auto& known) { return known.second == index; });
  std::string source;
  cmark_node* child = cmark_node_first_child(const_cast<cmark_node*>(node->first));
  for (; child != nullptr; child = cmark_node_next(child)) {
    const std::string text = plain_text(child);
    if (!text.starts_with("Source:") || text.size() < 9) continue;
    source = text.substr(text.find_first_not_of(' ', 7));
    for (cmark_node* part = cmark_node_first_child(child); part; part = cmark_node_next(part)) {
      if (cmark_node_get_type(part) != CMARK_NODE_LINK) continue;
      source += std::string(" <") + cmark_node_get_url(part) + ">";
    }
  }
  return source;
}

// The claims of one lesson.
class LessonClaims {
 public:
  LessonClaims(const Lesson& lesson, std::size_t index, const LessonResults& results,
               const Evaluation& evaluation, const Programs& programs,
               const std::set<Stand>& stands, ClaimSources& sources)
      : lesson_(lesson),
        index_(index),
        results_(results),
        evaluation_(evaluation),
        programs_(programs),
        stands_(stands),
        sources_(sources) {}

  Claims run() {
    for (std::size_t i = 0; i < lesson_.blocks.size(); ++i) {
      std::visit([&](const auto& block) { add(i, block); }, lesson_.blocks[i]);
    }
    return std::move(claims_);
  }

 private:
  void add(std::size_t i, const Example& example);
  void add_program(std::size_t i, const Example& example, const ExampleResult* result, Span extent);
  void add(std::size_t i, const Snippet& snippet);
  void add(std::size_t i, const Output& output);
  void add(std::size_t i, const ModelExcerpt& excerpt);
  void add(std::size_t i, const InlineModel& model);
  void add(std::size_t i, const InlineValue& value);
  void add(std::size_t i, const Math& math);
  void add(std::size_t i, const Lab& lab);
  void add(std::size_t i, const Figure& figure);
  void add(std::size_t i, const Chart& chart);
  void add(std::size_t i, const Image& image);
  void add(std::size_t i, const Quiz& quiz);
  void add(std::size_t i, const Callout& callout);
  void add(std::size_t i, const Unchecked& unchecked);
  // States nothing that could be untrue.
  void add(std::size_t, const Io&) {}
  void add(std::size_t, const TermUse&) {}
  void add(std::size_t, const Demo&) {}  // its blocks are the lesson's
  void add(std::size_t, const Shown&) {}

  Claim begin(Kind kind, std::size_t block, std::string what, Span extent) const;
  // `claim` is done: its key covers `parts` beside what every key does. A claim that would be
  // proved fails where there is nothing that was found, or where an error stands in it.
  void finish(Claim claim, bool found, const std::vector<std::string>& parts);
  bool has_error(Span extent) const;
  Span fence(Span opening) const { return fence_extent(*lesson_.source, opening); }
  const Versions& versions() const { return evaluation_.versions; }
  std::string programs_sources(const std::string& text) {
    return hash_of({sources_.helper(), sources_.models_named_in(text)});
  }

  const Lesson& lesson_;
  std::size_t index_;
  const LessonResults& results_;
  const Evaluation& evaluation_;
  const Programs& programs_;
  const std::set<Stand>& stands_;
  ClaimSources& sources_;
  Claims claims_;
};

Claim LessonClaims::begin(Kind kind, std::size_t block, std::string what, Span extent) const {
  Claim claim;
  claim.kind = kind;
  claim.status = Status::proved;
  claim.block = block;
  claim.what = std::move(what);
  claim.extent = extent;
  claim.place = place_of(*lesson_.source, extent);
  const auto seconds = results_.seconds.find(block);
  if (seconds != results_.seconds.end()) claim.seconds = seconds->second;
  return claim;
}

bool LessonClaims::has_error(Span extent) const {
  const Position begin = lesson_.source->position(extent.begin);
  const Position end = lesson_.source->position(extent.end);
  return std::any_of(
      evaluation_.diagnostics.begin(), evaluation_.diagnostics.end(), [&](const Diagnostic& d) {
        const auto at = std::tie(d.place.line, d.place.column);
        return d.severity == Severity::error && d.place.file == lesson_.source->path() &&
               at >= std::tie(begin.line, begin.column) && at <= std::tie(end.line, end.column);
      });
}

void LessonClaims::finish(Claim claim, bool found, const std::vector<std::string>& parts) {
  const bool wrong = has_error(claim.extent);
  if (!found || (wrong && claim.status == Status::proved)) {
    claim.status = Status::failed;
    claim.how = claim.limits = "";
    claim.reason = wrong ? "" : "what it rests on failed";
  }
  const std::string written(
      lesson_.source->text().substr(claim.extent.begin, claim.extent.end - claim.extent.begin));
  claim.key =
      hash_of({name_of(claim.kind), name_of(claim.status), claim.what, claim.how, claim.limits,
               claim.reason, written, versions().mjcourse, versions().mujoco, hash_of(parts)});
  claims_.push_back(std::move(claim));
}

void LessonClaims::add_program(std::size_t i, const Example& example, const ExampleResult* result,
                               Span extent) {
  Claim claim = begin(Kind::program, i, example.file.text, extent);
  claim.how = how_run(example, versions());
  if (example.compiles) claim.limits = limits_of_run(example.seconds);
  if (result == nullptr) return finish(std::move(claim), false, {example.code.text});
  claim.run_seconds = result->run_seconds;
  finish(std::move(claim), true,
         {result->code, result->output, text_of(result->records), versions().compiler,
          programs_sources(result->code)});
}

void LessonClaims::add(std::size_t i, const Example& example) {
  const Span extent = fence(example.span);
  const auto program = programs_.find(example.file.text);
  const ExampleResult* whole = program == programs_.end() ? nullptr : &program->second;
  if (!example.region) return add_program(i, example, whole, extent);
  // An error inside the fence is the region's own; of the program's there, none would be left.
  if (stands_.contains({index_, i})) add_program(i, example, whole, {extent.begin, extent.begin});
  Claim claim = begin(Kind::region, i, example.file.text + "#" + example.region->text, extent);
  claim.how = "compared with these lines of " + example.file.text + ", which was compiled and run";
  claim.limits = "indentation does not count";
  claim.seconds = 0;
  const auto* result = results_.get<ExampleResult>(i);
  finish(std::move(claim), result != nullptr,
         {result == nullptr ? "" : result->code, whole == nullptr ? "" : whole->code});
}

void LessonClaims::add(std::size_t i, const Snippet& snippet) {
  Claim claim =
      begin(Kind::snippet, i, "snippet: " + first_line(snippet.shown), fence(snippet.span));
  claim.how = how_run(snippet, versions());
  claim.limits = limits_of_run(snippet.seconds);
  const auto* result = results_.get<ExampleResult>(i);
  if (result != nullptr) claim.seconds = claim.run_seconds = result->run_seconds;
  finish(std::move(claim), result != nullptr,
         {result == nullptr ? "" : result->output, versions().compiler,
          sources_.model(snippet.model.text), programs_sources(snippet.code.text)});
}

void LessonClaims::add(std::size_t i, const Output& output) {
  const auto* example = std::get_if<Example>(&lesson_.blocks[output.example]);
  const std::string by = example != nullptr ? example->name() + ".cpp" : "the snippet above it";
  Claim claim = begin(Kind::output, i, "the output of " + by, fence(output.span));
  const auto* result = results_.get<OutputResult>(i);
  const auto* printed = results_.get<ExampleResult>(output.example);
  if (result != nullptr) claim.how = how_compared(output, *result, by);
  if (output.text.text.find("[..]") != std::string::npos) {
    claim.limits = "any text may stand for [..]";
  }
  finish(std::move(claim), result != nullptr,
         {printed == nullptr ? "" : printed->output, versions().compiler});
}

void LessonClaims::add(std::size_t i, const ModelExcerpt& excerpt) {
  const std::string file = "models/" + excerpt.model.text + ".xml";
  Claim claim = begin(Kind::listing, i, "a part of " + file, fence(excerpt.span));
  claim.how =
      "compared line by line with " + file + ", which MuJoCo " + versions().mujoco + " compiles";
  claim.limits = "indentation and blank lines do not count";
  finish(std::move(claim), results_.get<ModelResult>(i) != nullptr,
         {sources_.model(excerpt.model.text)});
}

void LessonClaims::add(std::size_t i, const InlineModel& model) {
  Claim claim = begin(Kind::listing, i, "a model", fence(model.span));
  const auto* result = results_.get<ModelResult>(i);
  claim.how = "compiled by MuJoCo " + versions().mujoco;
  if (!model.compiles) claim.how += ", which refuses it, as the lesson says";
  finish(std::move(claim), result != nullptr, {result == nullptr ? "" : result->refusal});
}

void LessonClaims::add(std::size_t i, const InlineValue& value) {
  Claim claim = begin(Kind::value, i, value.expression.text + " of " + value.source.text,
                      {value.source.span().begin, value.expression.span().end});
  const auto* result = results_.get<ValueResult>(i);
  if (result != nullptr) {
    claim.how = (result->origin.ends_with(".cpp")
                     ? "reported by " + value.source.text + ".cpp: "
                     : "computed from " + value.source.text + ".xml in its initial state: ") +
                result->text;
  }
  finish(std::move(claim), result != nullptr,
         {value.format.text, result == nullptr ? "" : result->text,
          sources_.model(value.source.text)});
}

void LessonClaims::add(std::size_t i, const Math& math) {
  Claim claim = begin(Kind::formula, i, as_title(math.tex.text), math.tex.span());
  claim.how = "typeset by KaTeX " + versions().katex;
  claim.limits = "that it is TeX, and not that it is true";
  const auto* result = results_.get<FormulaResult>(i);
  finish(std::move(claim), result != nullptr, {result == nullptr ? "" : result->markup});
}

void LessonClaims::add(std::size_t i, const Lab& lab) {
  const std::string title = "\u201c" + lab.title + "\u201d";
  const Span extent = fence(lab.span);
  const auto* result = results_.get<LabResult>(i);
  Claim claim = begin(Kind::lab, i, "the lab " + title, extent);
  if (result != nullptr) claim.how = how_rehearsed(lab, *result);
  claim.limits = "each control in each of its values by itself, a slider at both ends";
  const std::string model = sources_.model(lab.model.text);
  finish(std::move(claim), result != nullptr,
         {model,
          sources_.models_named_in(
              std::string(lesson_.source->text().substr(extent.begin, extent.end - extent.begin))),
          result == nullptr ? "" : text_of(*result)});
  if (result == nullptr) return;
  Claim picture = begin(Kind::picture, i, "the picture of the lab " + title, extent);
  picture.seconds = 0;
  picture.how = "drawn by MuJoCo " + versions().mujoco;
  finish(std::move(picture), result->poster.has_value(),
         {model, result->poster ? result->poster->png : ""});
}

void LessonClaims::add(std::size_t i, const Figure& figure) {
  Claim claim = begin(Kind::picture, i, as_title("a figure: " + figure.alt), fence(figure.span));
  const auto* result = results_.get<FigureResult>(i);
  claim.how = how_drawn(figure, versions());
  const std::string written(
      lesson_.source->text().substr(claim.extent.begin, claim.extent.end - claim.extent.begin));
  finish(std::move(claim), result != nullptr,
         {sources_.model(figure.model.text), sources_.models_named_in(written),
          result == nullptr ? "" : result->poster.png + result->film});
}

void LessonClaims::add(std::size_t i, const Chart& chart) {
  Claim claim = begin(Kind::plot, i, as_title("a plot: " + chart.alt), fence(chart.span));
  const auto* result = results_.get<ChartResult>(i);
  if (result != nullptr) claim.how = how_plotted(chart, *result);
  finish(std::move(claim), result != nullptr, {result == nullptr ? "" : result->drawings.wide.svg});
}

void LessonClaims::add(std::size_t i, const Image& image) {
  Claim claim =
      begin(Kind::image, i, as_title(image.file.text + ": " + image.alt), image.file.span());
  const auto* result = results_.get<ImageResult>(i);
  claim.status = image.title.empty() ? Status::asserted : Status::cited;
  claim.reason = image.title;
  finish(std::move(claim), result != nullptr, {result == nullptr ? "" : result->hash});
}

void LessonClaims::add(std::size_t i, const Quiz& quiz) {
  const auto* results = results_.get<QuizResult>(i);
  for (std::size_t q = 0; q < quiz.questions.size(); ++q) {
    const Question& question = quiz.questions[q];
    const QuestionResult result = results != nullptr ? results->questions[q] : QuestionResult{};
    Claim claim = begin(Kind::answer, i,
                        as_title("question " + std::to_string(q + 1) + ": " +
                                 (question.text ? plain_text(question.text.get()) : "")),
                        question.span);
    claim.part = q;
    claim.seconds = result.seconds;
    claim.limits = limits_of_answer(question);
    claim.how = how_proved(question, result);
    if (!result.proved) {
      claim.status = Status::asserted;
      claim.reason = result.because;
    }
    const std::string written(lesson_.source->text().substr(
        question.span.begin, question.span.end - question.span.begin));
    finish(std::move(claim), results != nullptr && !result.failed,
           {sources_.models_named_in(written)});
  }
}

void LessonClaims::add(std::size_t i, const Callout& callout) {
  if (callout.kind != "established") return;
  Claim claim =
      begin(Kind::citation, i, callout.title ? as_title(plain_text(callout.title.get())) : "a fact",
            callout.span);
  claim.reason = source_of(lesson_, i);
  claim.status = claim.reason.empty() ? Status::asserted : Status::cited;
  finish(std::move(claim), true, {});
}

void LessonClaims::add(std::size_t i, const Unchecked& unchecked) {
  Claim claim = begin(Kind::code, i, unchecked.language + ": " + first_line(unchecked.code.text),
                      fence(unchecked.span));
  claim.status = Status::unchecked;
  claim.reason = unchecked.because;
  finish(std::move(claim), true, {});
}

}  // namespace

void make_claims(const Course& course, const std::filesystem::path& root, const Programs& programs,
                 Evaluation& evaluation) {
  const std::set<Stand> stands = stands_of(course);
  ClaimSources sources(root, course.models);
  const auto fill = [&](const Lesson& page, std::size_t index, LessonResults& results) {
    results.claims =
        LessonClaims(page, index, results, evaluation, programs, stands, sources).run();
    results.tally = tally_of(results.claims);
  };
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    fill(course.lessons[i], i, evaluation.lessons[i]);
  }
  if (course.glossary) fill(course.glossary->page, course.lessons.size(), evaluation.glossary);
}

}  // namespace mjcourse
