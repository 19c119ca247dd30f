// A lesson, with the program and the model that it shows. What is true of them stands in it from
// the start. It is a draft until its author has put other things in their place.
// Tested by tests/generator/cli/new_part_test.cpp.
#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "base/utf8.h"
#include "cli/lesson_address.h"
#include "cli/new_part.h"
#include "cli/skeleton.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

// "forces_2" of "forces-2"
std::string with_underscores(std::string slug) {
  std::replace(slug.begin(), slug.end(), '-', '_');
  return slug;
}

// Values in the text call a model by a name that begins with a letter.
std::string model_name(const std::string& slug) {
  const bool digit = is_digit(slug[0]);
  return (digit ? "model_" : "") + with_underscores(slug);
}

// "l2_1_forces", "la_1_forces"
std::string example_name(const LessonName& lesson) {
  std::string level = lesson.level;
  level[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(level[0])));
  return "l" + level + "_" + std::to_string(lesson.place) + "_" + with_underscores(lesson.slug);
}

std::vector<NewFile> lesson_files(const LessonAddress& address, const Files& assets) {
  const auto& [level, name, title] = address;
  const std::string model = model_name(name.slug), example = example_name(name);
  return {{"content/" + level->folder + "/" + name.text() + ".md",
           filled_skeleton(assets, "lesson.md",
                           {{"title", nlohmann::json(title).dump()},
                            {"number", name.number()},
                            {"model", model},
                            {"example", example}})},
          {"examples/" + example + ".cpp",
           filled_skeleton(assets, "example.cpp", {{"name", example}, {"model", model}})},
          {"models/" + model + ".xml", filled_skeleton(assets, "model.xml", {{"name", model}})}};
}

}  // namespace

NewPartOrRefusal new_lesson(const Files& course, const Files& assets,
                            const std::vector<std::string>& words) {
  const auto file = read_course_file(course);
  if (!file) return tl::unexpected(file.error());
  const LessonNumbers numbers(course, *file);
  const auto address = lesson_address(*file, numbers, words);
  if (!address) return tl::unexpected(address.error());
  const auto& [level, name, title] = *address;
  if (const std::string other = numbers.taken_by(name); !other.empty()) {
    return wrong_course("the number " + name.number() + " is taken by " + other,
                        "the next one is " + numbers.next(*level, name.slug).number());
  }
  auto listed =
      edited_course_file(*file, with_lesson(file->yaml, level->folder, name.text()), "a lesson",
                         "`" + name.text() + "` among the `lessons` of " + level->folder);
  if (!listed) return tl::unexpected(listed.error());
  std::vector<NewFile> files = lesson_files(*address, assets);
  files.push_back(*std::move(listed));
  return NewPart{std::move(files), "",
                 "it is a draft: " + our_command("check") +
                     " proves it, and the site does not have it until "
                     "its line `draft: true` is gone"};
}

}  // namespace mjcourse
