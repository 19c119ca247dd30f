#include "evaluate/scenes/image.h"

#include <string>
#include <utility>
#include <vector>

#include "base/content_hash.h"
#include "base/files.h"
#include "base/nearest.h"
#include "evaluate/scenes/image_size.h"
#include "evaluate/scenes/svg_faults.h"
#include "lesson/syntax/image_kinds.h"
#include "lesson/syntax/picture_name.h"
#include "report/refused_file.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// The pictures beside the lesson, and in the folder that `file` names, as a lesson would name them.
std::vector<std::string> images_near(const fs::path& folder, const fs::path& file,
                                     const fs::path& root) {
  std::vector<fs::path> searched{""};
  if (file.has_parent_path()) searched.push_back(file.parent_path());
  std::vector<std::string> found;
  for (const fs::path& below : searched) {
    for (const std::string& name : DiskFiles(root).list((folder / below).string())) {
      if (is_image_file(name)) found.push_back(target_of_file((below / name).string()));
    }
  }
  return found;
}

// Reports what the drawing at `path` holds that pages must not bring; false where it does.
bool check_drawing(const std::string& path, const std::string& bytes, const Image& image,
                   const Lesson& lesson, Diagnostics& diagnostics) {
  const std::vector<SvgFault> faults = faults_of_svg(bytes);
  const SourceText drawing(path, bytes);
  for (const SvgFault& fault : faults) {
    Diagnostic found =
        error_at(place_of(drawing, fault.span), "E-image-svg", fault.message, fault.cure);
    found.notes.push_back({"lesson " + lesson.source->path() + " shows this drawing",
                           place_of(*lesson.source, image.file.span())});
    diagnostics.push_back(std::move(found));
  }
  return faults.empty();
}

}  // namespace

std::optional<ImageResult> evaluate_image(const Image& image, const Lesson& lesson,
                                          const fs::path& root, Diagnostics& diagnostics) {
  const fs::path folder = fs::path(lesson.source->path()).parent_path();
  const std::string path = (folder / image.file.text).string();
  const auto error = [&](const std::string& id, const std::string& message,
                         const std::string& cure) {
    diagnostics.push_back(error_at(place_of(*lesson.source, image.file.span()), id, message, cure));
    return std::nullopt;
  };
  const DiskFiles files(root);
  if (const auto refusal = files.refusal(path)) {
    diagnostics.push_back(
        refused_file(place_of(*lesson.source, image.file.span()), path, *refusal));
    return std::nullopt;
  }
  if (!files.exists(path)) {
    const std::vector<std::string> near = images_near(folder, image.file.text, root);
    return error("E-image-missing", "there is no file " + path,
                 near.empty() ? "put it there" : suggest(target_of_file(image.file.text), near));
  }
  const auto bytes = files.read(path);
  if (!bytes) return error("E-image-missing", "cannot read " + bytes.error(), "");
  const bool is_drawing = image.file.text.ends_with(".svg");
  if (is_drawing && !check_drawing(path, *bytes, image, lesson, diagnostics)) return std::nullopt;
  const tl::expected<ImageSize, std::string> size = image_size(image.file.text, *bytes);
  if (!size) {
    return error("E-image-broken", path + " " + size.error(),
                 is_drawing ? "give its `<svg>` a `viewBox`" : "save it again");
  }
  return ImageResult{root / path, content_hash(*bytes), size->width, size->height};
}

}  // namespace mjcourse
