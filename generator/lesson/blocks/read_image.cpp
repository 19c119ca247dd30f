#include "lesson/blocks/read_image.h"

#include <algorithm>
#include <filesystem>
#include <vector>

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
    return {"a picture lies beside its lesson, and not at an address on the web",
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

std::optional<Image> read_image(cmark_node* node, const LocatedText& file, bool alone,
                                Reading& reading) {
  if (const Refusal refusal = refuse(file.text); refusal.message != nullptr) {
    reading.error("E-image-place", file.span(), refusal.message, refusal.cure);
    return std::nullopt;
  }
  if (!is_image_file(file.text)) {
    reading.error("E-image-kind", file.span(),
                  "`" + file.text + "` is not in a supported picture format",
                  "pictures are .png, .jpg, .jpeg, .webp or .svg");
    return std::nullopt;
  }
  const std::string alt = plain_text(node);
  if (alt.find_first_not_of(' ') == alt.npos) {
    reading.error("E-image-alt", file.span(),
                  "this picture says nothing to readers who cannot see it",
                  "say in words what it shows: `![words](" + target_of_file(file.text) + ")`");
    return std::nullopt;
  }
  return Image{file, alt, cmark_node_get_title(node), alone};
}

// Markdown shows what it takes for no picture as it is written.
void refuse_blank_in_name(cmark_node* node, const LocatedText& text, std::size_t from,
                          Reading& reading) {
  const std::string literal = cmark_node_get_literal(node);
  const std::size_t shown = names_with_blanks({literal, {}}, 0).size();
  if (shown == 0) return;
  std::vector<LocatedText> names = names_with_blanks(text, from);
  names.resize(std::min(shown, names.size()));
  for (const LocatedText& name : names) {
    reading.error("E-image-blank", name.span(),
                  "Markdown reads this as text, since the name has a space in it",
                  "write `(" + target_of_file(name.text) + ")`");
  }
}

}  // namespace mjcourse
