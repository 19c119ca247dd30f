#include "page/html/site_paths.h"

#include <filesystem>
#include <string_view>

#include "base/percent_encoding.h"
#include "base/utf8.h"
#include "course/web_address.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostOfAName = 100;  // bytes of a picture's, which a hash follows

}  // namespace

// What is no ASCII stays as it is, since browsers take it so, and since readers' progress is kept
// under these names.
std::string site_address(const std::string& path) {
  constexpr std::string_view escaped = "\"#%&':<>?\\^`{|}";
  return percent_encoded(path, [&](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte > ' ' && byte != 0x7F && escaped.find(c) == escaped.npos;
  });
}

std::string way_to_root(const std::string& path) {
  std::string way;
  for (const char c : path) way += c == '/' ? "../" : "";
  return way;
}

std::string page_path(const Lesson& lesson) {
  return (lesson.folder.empty() ? "" : lesson.folder + "/") + lesson.slug + ".html";
}

std::string image_path(const Lesson& lesson, const Image& image, const ImageResult& result) {
  const std::filesystem::path file(image.file.text);
  std::string name = file.stem().string().substr(0, kMostOfAName);
  for (char& c : name) {
    const bool plain = is_word_character(c) || c == '-';
    if (!plain) c = '-';  // what an address would have to escape
  }
  const std::string page = page_path(lesson);
  return page.substr(0, page.rfind('.')) + "/" + name + "-" + result.hash +
         file.extension().string();
}

std::string block_path(const Lesson& lesson, std::size_t index) {
  return lesson.folder + "/" + lesson.slug + "/" + block_name(lesson, index);
}

std::string program_zip_path(const Example& example, const ExampleResult* result) {
  if (result == nullptr || !example.compiles) return "";
  const std::string& file = example.file.text;
  return file.substr(0, file.rfind('.')) + ".zip";
}

std::string exercise_path(const Exercise& exercise) {
  const std::string& file = exercise.program.file.text;
  return "exercises" + file.substr(file.find('/'));
}

std::string exercise_zip_path(const Exercise& exercise) {
  const std::string path = exercise_path(exercise);
  return path.substr(0, path.rfind('.')) + ".zip";
}

std::string web_address(const Course& course, const std::string& path) {
  if (course.url.empty()) return "";
  return course.url + (path == "index.html" ? "" : escaped_path(path));
}

}  // namespace mjcourse
