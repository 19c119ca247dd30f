#include "cli/lesson_numbers.h"

#include <algorithm>
#include <utility>

#include "page/course_data.h"

namespace mjcourse {

std::vector<LessonName> LessonNumbers::lessons_of(const ListedLevel& level) const {
  std::vector<std::string> names = level.lessons;
  for (const std::string& file : course_.list("content/" + level.folder)) {
    if (file.ends_with(".md")) names.push_back(file.substr(0, file.size() - 3));
  }
  std::vector<LessonName> lessons;
  for (const std::string& name : names) {
    if (auto lesson = read_lesson_name(name)) lessons.push_back(*std::move(lesson));
  }
  return lessons;
}

std::string LessonNumbers::letter_of(const ListedLevel& level) const {
  if (!level.number.empty()) return level.number;
  const std::vector<LessonName> own = lessons_of(level);
  if (!own.empty()) return own.back().level;
  std::string letter = "A";
  const auto is_taken = [&](const ListedLevel& other) {
    const std::vector<LessonName> all = lessons_of(other);
    return std::any_of(all.begin(), all.end(),
                       [&](const LessonName& lesson) { return lesson.level == letter; });
  };
  while (letter[0] < 'Z' && std::any_of(file_.levels.begin(), file_.levels.end(), is_taken)) {
    ++letter[0];
  }
  return letter;
}

LessonName LessonNumbers::next(const ListedLevel& level, const std::string& slug) const {
  LessonName next{letter_of(level), 1, slug};
  for (const LessonName& lesson : lessons_of(level)) {
    if (lesson.level == next.level) next.place = std::max(next.place, lesson.place + 1);
  }
  return next;
}

const ListedLevel* LessonNumbers::level_of(const LessonName& name) const {
  const auto level =
      std::find_if(file_.levels.begin(), file_.levels.end(), [&](const ListedLevel& one) {
        return letter_of(one) == name.level && (!one.number.empty() || !lessons_of(one).empty());
      });
  return level == file_.levels.end() ? nullptr : &*level;
}

std::string LessonNumbers::taken_by(const LessonName& name) const {
  for (const ListedLevel& level : file_.levels) {
    for (const LessonName& lesson : lessons_of(level)) {
      if (lesson.number() == name.number()) return level.folder + "/" + lesson.text();
    }
  }
  return "";
}

}  // namespace mjcourse
