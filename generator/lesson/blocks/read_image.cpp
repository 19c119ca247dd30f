// Pictures of a lesson: `![what it shows](file.png "where it comes from")`.
#include <algorithm>
#include <filesystem>
#include <vector>

#include "lesson/blocks/lesson_reader.h"
#include "lesson/syntax/image_kinds.h"
#include "lesson/syntax/picture_name.h"

namespace mjcourse {
namespace {

// Why `file` cannot name a picture beside the lesson, and what to do; empty where it can.
struct Refusal {
  const char* message = nullptr;
  const char* cure = "";
};

Refusal refuse(const std::string& file) {
  const std::filesystem::path path(file);
  if (file.empty())
    return {"this picture names no file", "name one: `![what it shows](picture.png)`"};
  if (file.find(':') != file.npos || file.starts_with("//")) {
    return {"a picture lies beside its lesson, and is no address in the web",
            "put the file there, and say where it comes from in its title: "
            "`![what it shows](picture.png \"where it comes from\")`"};
  }
  const bool leaves = std::find(path.begin(), path.end(), "..") != path.end();
  if (path.is_absolute() || leaves || file.find('\\') != file.npos) {
    return {"a picture lies in the folder of its lesson, or below it", "put the file there"};
  }
  return {};
}

}  // namespace

void LessonReader::read_image(cmark_node* node, Region& region) {
  const std::string url = cmark_node_get_url(node);
  // The text of the picture, which may hold the file's name as well, stands before it.
  const std::size_t target = region.text.text.find("](", region.cursor);
  if (target != std::string::npos) region.cursor = target + 2;
  const LocatedText file = file_of_target(find(url, region));
  if (const Refusal refusal = refuse(file.text); refusal.message != nullptr) {
    return reading_.error("E-image-place", file.span(), refusal.message, refusal.cure);
  }
  if (!is_image_file(file.text)) {
    return reading_.error("E-image-kind", file.span(),
                          "`" + file.text + "` is no picture that pages show",
                          "pictures are .png, .jpg, .jpeg, .webp or .svg");
  }
  const std::string alt = plain_text(node);
  if (alt.find_first_not_of(' ') == alt.npos) {
    return reading_.error(
        "E-image-alt", file.span(), "this picture says nothing to who cannot see it",
        "say in words what it shows: `![words](" + target_of_file(file.text) + ")`");
  }
  const bool alone = stands_alone(node);
  add(alone ? cmark_node_parent(node) : node, Image{file, alt, cmark_node_get_title(node), alone});
}

// Markdown shows what it takes for no picture as it is written.
void LessonReader::refuse_blank_in_name(cmark_node* text, const Region& region) {
  const std::string literal = cmark_node_get_literal(text);
  const std::size_t shown = names_with_blanks({literal, {}}, 0).size();
  if (shown == 0) return;
  std::vector<LocatedText> names = names_with_blanks(region.text, region.cursor);
  names.resize(std::min(shown, names.size()));
  for (const LocatedText& name : names) {
    reading_.error("E-image-blank", name.span(),
                   "Markdown takes this for text, since the name has a blank in it",
                   "write `(" + target_of_file(name.text) + ")`");
  }
}

// Is the picture a whole paragraph of the lesson's own text?
bool LessonReader::stands_alone(cmark_node* node) const {
  cmark_node* paragraph = cmark_node_parent(node);
  if (!in_document_ || cmark_node_get_type(paragraph) != CMARK_NODE_PARAGRAPH) return false;
  if (cmark_node_next(node) != nullptr || cmark_node_previous(node) != nullptr) return false;
  return !in_callout_title_;
}

}  // namespace mjcourse
