#include "cli/course_file.h"

#include <algorithm>

#include "base/utf8.h"
#include "cli/run.h"
#include "course/level_folder.h"
#include "process/our_command.h"

namespace mjcourse {

Refusal no_course(const std::string& why) {
  return {kCourseErrors, "there is no course here: " + why,
          "name its folder with --course DIR, or begin one: " + our_command("init DIR")};
}

const ListedLevel* CourseFile::find_level(const std::string& name) const {
  const auto found = std::find_if(levels.begin(), levels.end(), [&](const ListedLevel& level) {
    return level.folder == name || (!level.number.empty() && level.number == name);
  });
  return found == levels.end() ? nullptr : &*found;
}

std::vector<std::string> CourseFile::folders() const {
  std::vector<std::string> folders;
  for (const ListedLevel& level : levels) folders.push_back(level.folder);
  return folders;
}

tl::expected<CourseFile, Refusal> read_course_file(const Files& course) {
  const auto yaml = course.read(kCoursePath);
  if (!yaml) return tl::unexpected(no_course(yaml.error()));
  auto levels = read_listing(*yaml);
  const auto is_faulty = [](const ListedLevel& level) {
    return fault_of_level_folder(level.folder).has_value();
  };
  if (!levels || std::ranges::any_of(*levels, is_faulty)) {
    return wrong_course(std::string(kCoursePath) + " has mistakes, so nothing was written",
                        "fix them first: " + our_command("check") + " shows them");
  }
  return CourseFile{*yaml, *std::move(levels)};
}

tl::expected<NewFile, Refusal> edited_course_file(const CourseFile& file,
                                                  std::optional<std::string> edited,
                                                  const std::string& what,
                                                  const std::string& line) {
  if (edited) return NewFile{kCoursePath, *std::move(edited), file.yaml};
  return wrong_course(std::string(kCoursePath) + " is laid out in a way that " + what +
                          " cannot be put into safely, so nothing was written",
                      "write it there yourself: " + line);
}

tl::expected<void, Refusal> check_title(const std::string& title) {
  const bool is_line = !title.empty() && !find_invalid_utf8(title) &&
                       title.find_first_not_of(' ') != title.npos && readable(title) == title;
  if (is_line) return {};
  return wrong_words("`" + readable(title) + "` is not a title", "a title is one line of text");
}

}  // namespace mjcourse
