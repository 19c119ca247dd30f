#include "course/missing_lesson.h"

#include <algorithm>
#include <vector>

#include "base/nearest.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr const char* kLessonsFolder = "content";
constexpr const char* kMarkdown = ".md";
constexpr const char* kNotThere = ": No such file or directory";

// The lessons of a folder, as course.yaml lists them.
std::vector<std::string> lessons_in(const Files& files, const std::string& folder) {
  std::vector<std::string> lessons;
  for (const std::string& name : files.list(folder)) {
    if (name.ends_with(kMarkdown)) lessons.push_back(name.substr(0, name.size() - 3));
  }
  return lessons;
}

std::string cure_for(const std::string& written, const std::vector<std::string>& known) {
  const std::string small = lower_case_utf8(written);
  for (const std::string& name : known) {
    if (lower_case_utf8(name) == small) {
      return "did you mean `" + name + "`? Capital and small letters differ";
    }
  }
  return known.empty() ? "write it, or take it from the list" : suggest(written, known);
}

}  // namespace

MissingLesson missing_lesson(const Files& files, const std::string& folder,
                             const std::string& entry) {
  const std::string place = std::string(kLessonsFolder) + "/" + folder;
  const std::string path = place + "/" + entry + kMarkdown;
  const auto bytes = files.read(path);
  if (!bytes && !bytes.error().ends_with(kNotThere)) {
    return {"cannot read " + bytes.error(), "a lesson is a text file that you can read"};
  }
  const std::vector<std::string> lessons = lessons_in(files, place);
  if (entry.ends_with(kMarkdown)) {
    const std::string name = entry.substr(0, entry.size() - 3);
    if (std::ranges::count(lessons, name) > 0) {
      return {"a lesson is listed without `.md`", "write `" + name + "`"};
    }
  }
  const std::vector<std::string> folders = files.folders(kLessonsFolder);
  if (lessons.empty() && std::ranges::count(folders, folder) == 0) {
    return {"there is no folder " + place, cure_for(folder, folders)};
  }
  return {"there is no file " + path, cure_for(entry, lessons)};
}

}  // namespace mjcourse
