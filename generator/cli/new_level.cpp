// Tested by tests/generator/cli/new_part_test.cpp.
#include <re2/re2.h>

#include <algorithm>

#include "cli/course_file.h"
#include "cli/new_part.h"
#include "course/lesson_name.h"
#include "course/level_folder.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

std::string level_form() {
  return our_command("new level 2-dynamics \"Dynamics\"");
}

struct Named {
  std::string folder, title;
};

// One more than the largest of the course's.
std::string next_number(const CourseFile& file) {
  int largest = 0;
  for (const ListedLevel& level : file.levels) {
    if (!level.number.empty()) largest = std::max(largest, std::stoi(level.number.substr(0, 6)));
  }
  return std::to_string(largest + 1);
}

// "2-dynamics" with or without a title, or a title alone, which gets the next number.
tl::expected<Named, Refusal> name_of(const CourseFile& file,
                                     const std::vector<std::string>& words) {
  static const RE2 folder(R"((\d{1,6}-)?[a-z][a-z0-9]*(-[a-z0-9]+)*)");
  if (words.empty()) {
    return wrong_words("new level needs a name", "as in " + level_form());
  }
  if (words.size() > 2) {
    return wrong_words("new level takes a name and a title, not `" + words[2] + "`",
                       "put a title of several words into quotes: " + level_form());
  }
  if (const auto good = check_title(words.back()); !good) return tl::unexpected(good.error());
  if (RE2::FullMatch(words[0], folder)) {
    const std::string slug = words[0].substr(level_number(words[0]).size());
    const std::string title = title_of(slug.starts_with('-') ? slug.substr(1) : slug);
    return Named{words[0], words.size() == 2 ? words[1] : title};
  }
  const std::string slug = slug_of(words[0]);
  const bool is_slug = RE2::FullMatch(slug, folder);
  const bool is_title = words[0].find_first_of("/_.") == words[0].npos;
  if (words.size() == 1 && is_slug && is_title && level_number(slug).empty()) {
    return Named{next_number(file) + "-" + slug, words[0]};
  }
  return wrong_words("`" + words[0] + "` is not a name for a level",
                     "a number, then small letters, digits and hyphens, as in " + level_form() +
                         (is_slug ? "; did you mean `" + slug + "`?" : ""));
}

}  // namespace

NewPartOrRefusal new_level(const Files& course, const std::vector<std::string>& words) {
  const auto file = read_course_file(course);
  if (!file) return tl::unexpected(file.error());
  const auto named = name_of(*file, words);
  if (!named) return tl::unexpected(named.error());
  if (const auto fault = fault_of_level_folder(named->folder)) {
    return wrong_words(fault->text(), "choose another name, as in " + level_form());
  }
  if (file->find_level(named->folder) != nullptr) {
    return wrong_course("the course has a level " + named->folder + " already",
                        "choose another name");
  }
  const std::string number = level_number(named->folder);
  const ListedLevel* same = number.empty() ? nullptr : file->find_level(number);
  if (same != nullptr) {
    return wrong_course("level " + number + " is there already: " + same->folder,
                        "the next number is " + next_number(*file));
  }
  auto edited =
      edited_course_file(*file, with_level(file->yaml, named->folder, named->title), "a level",
                         "a level with `folder: " + named->folder + "` and a `title`");
  if (!edited) return tl::unexpected(edited.error());
  return NewPart{{*std::move(edited)},
                 "content/" + named->folder,
                 "its first lesson: " + our_command("new lesson " + named->folder + " \"TITLE\"")};
}

}  // namespace mjcourse
