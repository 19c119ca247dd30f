// `mjcourse init DIR [TITLE]`: a course that checks and builds at once. Its files are skeletons,
// and what every course's examples have: their CMake file and the helper header.
// Tested by tests/system/begin.mjs.
#include <array>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/checkout.h"
#include "base/out_folder.h"
#include "cli/ci_files.h"
#include "cli/commands.h"
#include "cli/course_file.h"
#include "cli/new_files.h"
#include "cli/run.h"
#include "cli/skeleton.h"
#include "cli/verify.h"
#include "course/lesson_name.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// In skeleton/course as in the course.
constexpr std::array kSkeletons{"README.md", ".gitignore",
                                "content/1-first-steps/1.1-a-pendulum.md", "content/course.yaml"};
// In the assets as in the course.
constexpr std::array kExamples{"examples/CMakeLists.txt", "examples/include/mjcourse/mjcourse.hpp",
                               "examples/include/mjcourse/handlers.cpp"};

constexpr const char* kModel = "pendulum";
constexpr const char* kExample = "l1_1_a_pendulum";

std::vector<NewFile> course_files(const Files& assets, const std::string& title,
                                  const std::string& ci) {
  std::vector<NewFile> files = ci_files(assets, ci);
  const std::string ci_file = files.front().path;
  for (const std::string path : kSkeletons) {
    files.push_back({path, filled_skeleton(assets, "course/" + path,
                                           {{"title", title},
                                            {"quoted_title", nlohmann::json(title).dump()},
                                            {"ci_file", ci_file},
                                            {"model", kModel},
                                            {"example", kExample}})});
  }
  files.push_back({std::string("models/") + kModel + ".xml",
                   filled_skeleton(assets, "model.xml", {{"name", kModel}})});
  files.push_back(
      {std::string("examples/") + kExample + ".cpp",
       filled_skeleton(assets, "example.cpp", {{"name", kExample}, {"model", kModel}})});
  for (const std::string path : kExamples) {
    auto bytes = assets.read(path);
    if (!bytes) throw std::runtime_error("the helper header is not installed: " + bytes.error());
    files.push_back({path, *std::move(bytes)});
  }
  return files;
}

// What a folder holds that is not git's; "" where a course may begin there.
std::string first_of(const fs::path& folder) {
  std::string first;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name != ".git" && (first.empty() || name < first)) first = name;
  }
  return first;
}

std::string title_for(const fs::path& folder) {
  const std::string title = title_of(slug_of(folder.filename().string()));
  return title.empty() ? "A course" : title;
}

// No link is followed that lies in the checkout where its author works: it may be a stranger's.
tl::expected<void, Refusal> look_for_links(const fs::path& folder) {
  const OutPath found = find_out_path(folder, checkout_of(fs::current_path()).value_or(""));
  if (!found.is_link) return {};
  return wrong_course(found.path.string() + " is a link, so nothing is written there",
                      "name a folder elsewhere");
}

// `named` is how its author calls it.
tl::expected<void, Refusal> look_at(const fs::path& folder, const std::string& named) {
  if (!fs::exists(folder)) return {};
  if (!fs::is_directory(folder)) {
    return wrong_course(named + " is not a folder", "name a new or empty one");
  }
  const std::string first = first_of(folder);
  if (first.empty()) return {};
  return wrong_course(named + " is not empty: it has " + first,
                      "name a new or an empty folder; " + our_command("new") + " adds to a course");
}

}  // namespace

int init(const InitOptions& options) {
  const std::vector<std::string>& words = options.words;
  const std::string form = our_command("init my-course \"My course\"");
  if (words.empty()) return tell({kWrongUsage, "init needs a folder", "as in " + form});
  if (words.size() > 2) {
    return tell({kWrongUsage, "init takes a folder and a title, not `" + words[2] + "`",
                 std::string("put a title of several words into quotes: ") + form});
  }
  if (words.size() == 2) {
    if (const auto good = check_title(words[1]); !good) return tell(good.error());
  }
  const fs::path folder = fs::absolute(words[0]).lexically_normal();
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  if (const auto good = check_length(named); !good) return tell(good.error());
  if (const auto good = look_for_links(named); !good) return tell(good.error());
  if (const auto free = look_at(named, words[0]); !free) return tell(free.error());
  const std::string title = words.size() == 2 ? words[1] : title_for(named);
  const std::vector<NewFile> files = course_files(DiskFiles(assets_folder()), title, options.ci);
  if (const auto written = write_new_files(named, files); !written) return tell(written.error());
  tell(files);
  std::cout << "now: " << our_command("check --course " + words[0]) << ", and read its README.md\n";
  return kClean;
}

}  // namespace mjcourse
