#include "cli/lesson_address.h"

#include <re2/re2.h>

#include <optional>

#include "base/nearest.h"
#include "page/course_data.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

using AddressOrRefusal = tl::expected<LessonAddress, Refusal>;
using Words = std::vector<std::string>;

tl::unexpected<Refusal> no_lesson_name(const std::string& name) {
  const std::string slug = slug_of(name.substr(name.find_last_of('/') + 1));
  return wrong_words("`" + name + "` is not a name for a lesson",
                     "a number, then small letters, digits and hyphens, such as `2.1-forces`" +
                         (slug.empty() ? std::string() : "; did you mean `" + slug + "`?"));
}

tl::unexpected<Refusal> no_level(const CourseFile& file, const std::string& name) {
  const std::vector<std::string> known = file.folders();
  const std::string new_level = our_command("new level " + name) + " makes it; ";
  return wrong_words("there is no level " + name + " in content/course.yaml",
                     (nearest(name, known).empty() ? new_level : "") + suggest(name, known));
}

AddressOrRefusal in_level(const ListedLevel& level, const LessonNumbers& numbers,
                          const Words& words) {
  if (words.size() < 2) {
    return wrong_words("a lesson of " + level.folder + " needs a title",
                       our_command("new lesson " + level.folder + " \"TITLE\""));
  }
  const std::string slug = slug_of(words[1]);
  if (!slug.empty()) return LessonAddress{&level, numbers.next(level, slug), words[1]};
  return wrong_words(
      "no file's name is made of `" + words[1] + "`: it has letters that are not English, or none",
      "name the file too, as in " + our_command("new lesson " + level.folder + "/" +
                                                numbers.next(level, "NAME").text() + " \"TITLE\""));
}

// "forces" or "2.1-forces" in `level`; null: in the level that has such numbers.
AddressOrRefusal named(const CourseFile& file, const ListedLevel* level, const std::string& name,
                       const LessonNumbers& numbers, const Words& words) {
  static const RE2 slug("[a-z0-9]+(-[a-z0-9]+)*");
  std::optional<LessonName> wanted = read_lesson_name(name);
  if (!wanted && level != nullptr) wanted = numbers.next(*level, name);
  if (!wanted || !RE2::FullMatch(wanted->slug, slug)) return no_lesson_name(words[0]);
  if (level == nullptr) level = numbers.level_of(*wanted);
  if (level == nullptr) {
    return wrong_words(
        "no level in content/course.yaml has lessons with numbers such as " + wanted->number(),
        "name the level too: " + our_command("new lesson LEVEL/" + wanted->text()) + "; " +
            suggest("", file.folders()));
  }
  if (!level->number.empty() && wanted->level != level->number) {
    return wrong_words(
        "a lesson of " + level->folder + " has a number as " + level->number + ".1",
        "did you mean `" + level->folder + "/" + numbers.next(*level, wanted->slug).text() + "`?");
  }
  return LessonAddress{level, *wanted, words.size() > 1 ? words[1] : title_of(wanted->slug)};
}

}  // namespace

tl::expected<LessonAddress, Refusal> lesson_address(const CourseFile& file,
                                                    const LessonNumbers& numbers,
                                                    const Words& words) {
  if (words.empty()) {
    return wrong_words(
        "new lesson needs a level and a title",
        our_command("new lesson 2-dynamics \"Forces\"") + " takes the level's next number, " +
            our_command("new lesson 2-dynamics/2.1-forces \"Forces\"") + " names all of it");
  }
  if (words.size() > 2) {
    return wrong_words("new lesson takes a name and a title, not `" + words[2] + "`",
                       "put a title of several words into quotes");
  }
  if (words.size() == 2) {
    if (const auto good = check_title(words[1]); !good) return tl::unexpected(good.error());
  }
  // As the shell completes it.
  static const RE2 path(R"((?s)(?:content/)?(.*?)(?:/|\.md)?)", RE2::Latin1);
  std::string name;
  RE2::FullMatch(words[0], path, &name);
  if (const ListedLevel* level = file.find_level(name)) return in_level(*level, numbers, words);
  const std::size_t slash = name.find('/');
  if (slash == name.npos) {
    return read_lesson_name(name) ? named(file, nullptr, name, numbers, words)
                                  : no_level(file, name);
  }
  const ListedLevel* level = file.find_level(name.substr(0, slash));
  if (level == nullptr) return no_level(file, name.substr(0, slash));
  return named(file, level, name.substr(slash + 1), numbers, words);
}

}  // namespace mjcourse
