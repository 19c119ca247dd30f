#include "cli/exercise_list.h"

#include <algorithm>

#include "base/nearest.h"
#include "base/utf8.h"
#include "cli/where.h"
#include "lesson/syntax/markdown.h"
#include "process/our_command.h"

namespace mjcourse {

std::vector<ListedExercise> exercises_of(const Course& course) {
  std::vector<ListedExercise> all;
  for (const Lesson& lesson : course.lessons) {
    std::string title;
    for (const Block& block : lesson.blocks) {
      if (const auto* callout = std::get_if<Callout>(&block)) {
        title = callout->title ? plain_text(callout->title.get()) : "";
      }
      const auto* exercise = std::get_if<Exercise>(&block);
      if (exercise != nullptr) {
        all.push_back({&lesson, exercise, exercise->program.name(), title});
      }
    }
  }
  return all;
}

tl::expected<ListedExercise, Refusal> find_exercise(const Course& course,
                                                    const std::filesystem::path& root,
                                                    const std::vector<std::string>& words) {
  const std::string form = "as in " + our_command("try 1.1 l1_1_sensors");
  if (words.empty() || words.size() > 2) {
    return wrong_words("try takes a lesson and the name of an exercise", form);
  }
  const auto where = find_place(course, root, words[0]);
  if (!where) return wrong_words(where.error(), form);
  std::vector<ListedExercise> known = exercises_of(course);
  std::erase_if(known, [&](const ListedExercise& one) { return one.lesson != where->lesson; });
  const std::string lesson = "lesson " + where->lesson->number;
  if (known.empty()) return wrong_words(lesson + " has no exercise that is checked", form);
  if (words.size() == 1 && known.size() == 1) return known.front();
  std::vector<std::string> names;
  for (const ListedExercise& one : known) names.push_back(one.name);
  if (words.size() == 1) {
    std::string list;
    for (const ListedExercise& one : known) {
      list += "\n  " + our_command("try " + words[0] + " " + one.name) + "  " + readable(one.title);
    }
    return wrong_words(lesson + " has several exercises", "choose one:" + list);
  }
  const auto named = std::ranges::find(known, words[1], &ListedExercise::name);
  if (named != known.end()) return *named;
  return wrong_words(lesson + " has no exercise " + words[1], suggest(words[1], names));
}

std::string check_text(const Check& check) {
  std::string text = (check.holds ? "  [x] " : "  [ ] ") + readable(check.what) + "\n";
  for (const std::string& words : {check.meaning, check.found}) {
    if (!check.holds && !words.empty()) text += "      " + readable(words) + "\n";
  }
  return text;
}

}  // namespace mjcourse
