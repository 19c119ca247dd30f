#include "evaluate/claims/claims.h"

#include <variant>

#include "base/any_of.h"
#include "base/parallel.h"
#include "evaluate/claims/code_claims.h"
#include "evaluate/claims/prose_claims.h"
#include "evaluate/claims/shown_claims.h"
#include "lesson/unloaded_lesson.h"

namespace mjcourse {
namespace {

std::set<Stand> stands_of(const Course& course) {
  std::set<std::string> whole;
  std::set<Stand> stands;
  for (const bool regions : {false, true}) {
    for (std::size_t l = 0; l < course.lessons.size(); ++l) {
      for (std::size_t b = 0; b < course.lessons[l].blocks.size(); ++b) {
        const Block& block = course.lessons[l].blocks[b];
        const auto* exercise = std::get_if<Exercise>(&block);
        const auto* example =
            exercise != nullptr ? &exercise->program : std::get_if<Example>(&block);
        if (example == nullptr || example->region.has_value() != regions) continue;
        const bool is_new = whole.insert(example->file.text).second;
        if (regions && is_new) stands.insert({l, b});
      }
    }
  }
  return stands;
}

// Those that state nothing which could be untrue; the blocks of a demo are the lesson's.
template <AnyOf<Io, TermUse, Demo, Shown> Other>
void claim(const Other&, std::size_t, ClaimContext&) {}

Claims claims_of(ClaimContext context) {
  const std::vector<Block>& blocks = context.lesson.blocks;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    std::visit([&](const auto& block) { claim(block, i, context); }, blocks[i]);
  }
  return std::move(context.claims);
}

}  // namespace

void make_claims(const Course& course, ClaimSources& sources, const Programs& programs,
                 std::size_t threads, Evaluation& evaluation) {
  const std::set<Stand> stands = stands_of(course);
  const std::size_t glossary = course.lessons.size();
  for_each_index(
      glossary + (course.glossary ? 1 : 0), threads, [&](std::size_t index, std::size_t) {
        const bool is_lesson = index < glossary;
        const Lesson& page = is_lesson ? course.lessons[index] : course.glossary->page;
        LessonResults& results = is_lesson ? evaluation.lessons[index] : evaluation.glossary;
        if (page.kept == Lesson::Kept::outline) {
          results.tally.unchecked = page.unchecked;
          return;
        }
        results.claims = claims_of({page, index, results, evaluation, programs, stands, sources});
        results.tally = tally_of(results.claims);
      });
}

Claims claims_of_prose(const Lesson& lesson, const Evaluation& evaluation) {
  const LessonResults none;
  const Programs programs;
  const std::set<Stand> stands;
  Fingerprints fingerprints("/");
  ClaimSources sources("/", {}, {}, fingerprints);
  return claims_of({lesson, 0, none, evaluation, programs, stands, sources});
}

void claim_prose(Course& course, const Files& files, Evaluation& evaluation) {
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    Lesson& lesson = course.lessons[i];
    if (lesson.kept != Lesson::Kept::outline) continue;
    lesson = reload(lesson, files);
    unload(lesson, Lesson::Kept::blocks);
    evaluation.lessons[i].claims = claims_of_prose(lesson, evaluation);
  }
}

}  // namespace mjcourse
