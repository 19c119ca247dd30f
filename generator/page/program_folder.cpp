#include "page/program_folder.h"

#include <algorithm>

#include "base/cpp_includes.h"
#include "findings/path_in_folder.h"
#include "lesson/syntax/exercise_text.h"
#include "page/site_data.h"

namespace mjcourse {
namespace {

// Around the libraries that are looked for and the list of sources. The target has a name of its
// own, as not every program's is one that CMake takes.
constexpr const char* kCMakeHead = R"(cmake_minimum_required(VERSION 3.20)
project(program LANGUAGES CXX)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
# Not find_package(mujoco): Debian's package file for it names folders that no package brings.
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h REQUIRED)
)";
constexpr const char* kCMakeTail = R"( Eigen3::Eigen)
target_compile_features(program PRIVATE cxx_std_20)
target_include_directories(program PRIVATE include)
target_include_directories(program SYSTEM PRIVATE ${MUJOCO_INCLUDE_DIR})
target_compile_definitions(program PRIVATE MJCOURSE_MODELS="${CMAKE_CURRENT_SOURCE_DIR}/models")
set_target_properties(program PROPERTIES OUTPUT_NAME )";

// What it printed: of who builds it, and of the page that runs it.
constexpr const char* kOutputFile = "expected-output.txt";

std::string cmake_lists(const TakenProgram& program, const std::string& text) {
  std::string find, link;
  for (const std::string& library : linked_libraries(text)) {
    find += "find_library(LIB_" + library + " " + library + " REQUIRED)\n";
    link += " ${LIB_" + library + "}";
  }
  std::string sources = " \"" + program.example.name() + ".cpp\"";
  for (const std::string& file : program.result.files) {
    if (file.ends_with(".cpp")) sources += " \"" + path_in_folder(file, program.example) + "\"";
  }
  return kCMakeHead + find + "\nadd_executable(program" + sources +
         ")\ntarget_link_libraries(program PRIVATE" + link + kCMakeTail + "\"" +
         program.example.name() + "\")\n";
}

// A word of a command line.
std::string shell_word(const std::string& word) {
  const bool plain = word.find_first_not_of(
                         "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                         "0123456789_./=+-,:@") == word.npos;
  if (plain && !word.empty()) return word;
  std::string inside;
  for (const char c : word) inside += c == '\'' ? "'\\''" : std::string(1, c);
  return "'" + inside + "'";
}

std::string readme(const TakenProgram& program, const std::string& text, const SiteData& site) {
  const Example& example = program.example;
  const bool draws = std::ranges::count(linked_libraries(text), "OSMesa") > 0;
  std::string run = shell_word("build/" + example.name());
  for (const std::string& argument : example.arguments) run += " " + shell_word(argument);
  return example.name() + ".cpp: a program of “" + site.course.title + "”, for MuJoCo " +
         site.evaluation.versions.mujoco +
         (draws ? ", Eigen 3.4 and OSMesa (Debian: libmujoco-dev, libeigen3-dev, libosmesa6-dev)\n"
                : " and Eigen 3.4 (Debian: libmujoco-dev, libeigen3-dev)\n") +
         "Lesson " + program.lesson.number + ": " + program.lesson.front.title.text + "\n" +
         "cmake -S . -B build && cmake --build build, then " + run + "\n";
}

// What is no file of the course is the tool's, under the same path.
std::string read_either(const std::string& path, const SiteData& site) {
  auto bytes = site.files.read(path);
  if (!bytes && !site.files.exists(path)) bytes = site.assets.read(path);
  if (!bytes) throw LostFile(bytes.error());
  return *std::move(bytes);
}

}  // namespace

std::map<std::string, std::string> program_folder(const TakenProgram& program,
                                                  const SiteData& site) {
  const std::string folder = program.example.name() + "/";
  const std::string text = program.text.empty()
                               ? without_exercise(read_either(program.example.file.text, site))
                               : program.text;
  std::map<std::string, std::string> files{{folder + program.example.name() + ".cpp", text},
                                           {folder + "CMakeLists.txt", cmake_lists(program, text)},
                                           {folder + "README.txt", readme(program, text, site)}};
  if (!program.result.output.empty()) files[folder + kOutputFile] = program.result.output;
  for (const std::string& path : program.result.files) {
    files[folder + path_in_folder(path, program.example)] = read_either(path, site);
  }
  return files;
}

}  // namespace mjcourse
