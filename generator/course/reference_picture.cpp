#include "course/reference_picture.h"

#include <set>
#include <utility>

#include "lesson/blocks/read_view.h"

namespace mjcourse {

std::string reference_path(const Lesson& lesson, const std::string& pin) {
  return "content/" + lesson.folder + "/pictures/" + lesson.number + "-" + pin + ".png";
}

void warn_of_unused_references(const Files& files, const Course& course, Diagnostics& diagnostics) {
  if (!diagnostics.empty()) return;
  std::set<std::string> used;
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks)
      used.insert(reference_path(lesson, pin_of(block).text));
  }
  for (const Level& level : course.levels) {
    const std::string folder = "content/" + level.folder + "/pictures";
    for (const std::string& name : files.list(folder)) {
      const std::string path = folder + "/" + name;
      if (!name.ends_with(".png") || used.contains(path)) continue;
      Diagnostic unused = error_at({path, 0, 0, 1, ""}, "W-picture-unused",
                                   "no lesson pins this picture any more", "remove the file");
      unused.severity = Severity::warning;
      diagnostics.push_back(std::move(unused));
    }
  }
}

}  // namespace mjcourse
