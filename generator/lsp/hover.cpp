#include "lsp/hover.h"

#include <algorithm>

#include "lsp/editor_diagnostics.h"
#include "lsp/lesson_fences.h"
#include "lsp/markdown.h"
#include "lsp/place_words.h"
#include "lsp/plot_words.h"
#include "lsp/script_cursor.h"
#include "physics/mujoco_api.h"
#include "report/meaning.h"
#include "session/former_results.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// What is said, and of which bytes.
struct Said {
  std::string markdown;  // what a course says stands in it as lsp/markdown.h writes it
  Span span;
};

std::optional<Said> of_mistake(const Asked& asked) {
  const TextPoint point = point_of(*asked.text, asked.offset, asked.units);
  for (const Diagnostic& one : asked.snapshot->diagnostics) {
    const TextRange range = range_of(one.place, asked.units);
    const bool here = one.place.file == asked.text->path() && range.begin.line == point.line &&
                      range.begin.unit <= point.unit && point.unit <= range.end.unit;
    const Meaning* meaning = here ? meaning_of(one.id) : nullptr;
    if (meaning == nullptr) continue;
    return Said{"`" + one.id + "`\n\n" + plain_text_of(*meaning),
                {offset_of(*asked.text, range.begin, asked.units),
                 offset_of(*asked.text, range.end, asked.units)}};
  }
  return std::nullopt;
}

std::string proof_text(const ProofResult& proof) {
  std::string text = "- " + escaped_for_markdown(proof.built);
  if (!proof.expression.empty()) text += ": " + code_for_markdown(proof.expression);
  if (!proof.value.empty()) text += " gives " + code_for_markdown(proof.value);
  return text + "\n";
}

std::string question_text(const QuestionResult& question) {
  if (question.failed) return "The answer or a proof is wrong.";
  std::string text = question.proved ? "Proved:\n\n" : "Asserted";
  if (!question.proved) {
    text += question.because.empty() ? "." : ": " + escaped_for_markdown(question.because);
  }
  for (const ProofResult& proof : question.proofs) text += proof_text(proof);
  return text;
}

// Where nothing is known of a claim: it may be soon.
std::optional<Said> of_nothing(const Asked& asked, Span span) {
  if (!asked.snapshot->evaluation->open) return std::nullopt;
  return Said{"This is being worked out.", span};
}

// What was found of the block at the place, when it was looked at last.
std::optional<Said> of_result(const Asked& asked, const Lesson& lesson) {
  const FormerResults results(asked.snapshot);
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    if (const auto* value = std::get_if<InlineValue>(&lesson.blocks[i])) {
      const Span span{value->source.span().begin, value->expression.span().end};
      if (!asked.is_in(span)) continue;
      const auto result = results.find(lesson, i);
      if (!result) return of_nothing(asked, span);
      const auto& found = std::get<ValueResult>(*result);
      return Said{"**" + code_for_markdown(found.text) + "**: " + code_for_markdown(found.origin),
                  span};
    }
    if (const auto* quiz = std::get_if<Quiz>(&lesson.blocks[i])) {
      for (std::size_t q = 0; q < quiz->questions.size(); ++q) {
        const Span span = quiz->questions[q].span;
        if (!asked.is_in(span)) continue;
        const auto result = results.find(lesson, i);
        if (!result) return of_nothing(asked, span);
        return Said{question_text(std::get<QuizResult>(*result).questions[q]), span};
      }
    }
  }
  return std::nullopt;
}

std::optional<Said> of_api(const std::string& name, Span span) {
  const auto& api = installed_mujoco_api();
  if (!api) return std::nullopt;
  const auto found = api->find(name);
  if (found == api->end()) return std::nullopt;
  const ApiName& entry = found->second;
  std::string text = "```c\n" + entry.declaration + "\n```\n";
  if (!entry.comment.empty()) text += "\n" + entry.comment + "\n";
  return Said{text + "\n" + name + ", of " + entry.header, span};
}

std::optional<Said> of_link(const Asked& asked, const Lesson& lesson) {
  constexpr std::string_view scheme = "api:";
  for (const Link& link : lesson.links) {
    if (!link.target.text.starts_with(scheme) || !asked.is_in(link.target.span())) continue;
    return of_api(link.target.text.substr(scheme.size()), link.target.span());
  }
  return std::nullopt;
}

std::optional<Said> of_field(const Asked& asked) {
  const int line = asked.text->position(asked.offset).line;
  const std::size_t start = asked.text->line_start(line);
  const auto field = field_at(asked.text->line(line), asked.offset - start);
  if (!field) return std::nullopt;
  return of_api(field->name, {start + field->begin, start + field->end});
}

// Of the key that ends at `place`; empty where it is nobody's.
std::string meaning_of_key(const Asked& asked, std::string_view fence, const JsonPlace& place) {
  const Vocabulary* ours = words_at(fence, place).object;
  if (const Key* key = ours != nullptr ? ours->find(place.part) : nullptr) {
    return std::string(key->meaning);
  }
  const auto* theirs = fence == "plot" ? plot_object_at(asked.plots, place) : nullptr;
  const PlotGrammar::Key* key = theirs != nullptr ? theirs->find(place.part) : nullptr;
  return key != nullptr ? key->meaning : "";
}

// The key of a fence's JSON that stands at the place.
std::optional<Said> of_key(const Asked& asked) {
  const std::vector<LessonFence> fences = fences_of(*asked.text);
  const LessonFence* fence = fence_at(fences, asked.offset);
  if (fence == nullptr || asked.offset < fence->body.begin) return std::nullopt;
  const std::string_view text = asked.text->text();
  const std::size_t end = text.find_first_of("\"\n", asked.offset);
  if (end == text.npos || text[end] != '"') return std::nullopt;
  const JsonPlace place = json_place(unquoted(*asked.text, {fence->body.begin, end}));
  if (!place.in_string || !place.at_key() || place.part.size() > end) return std::nullopt;
  const std::string meaning = meaning_of_key(asked, fence->kind(), place);
  if (meaning.empty()) return std::nullopt;
  return Said{meaning, {end - place.part.size(), end}};
}

std::optional<Said> said_at(const Asked& asked) {
  if (auto said = of_mistake(asked)) return said;
  if (auto said = of_field(asked)) return said;
  if (auto said = of_key(asked)) return said;
  const std::optional<Lesson> lesson = asked.lesson();
  if (!lesson) return std::nullopt;
  if (auto said = of_link(asked, *lesson)) return said;
  return of_result(asked, *lesson);
}

}  // namespace

json hover_at(const Asked& asked) {
  const auto said = said_at(asked);
  if (!said) return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", said->markdown}}},
          {"range", json_of(range_of(*asked.text, said->span, asked.units))}};
}

}  // namespace mjcourse
