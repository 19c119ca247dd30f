// Pictures of the author's: that they are there, and how large they are.
#pragma once

#include <filesystem>
#include <optional>

#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// `root` is the course's folder.
std::optional<ImageResult> evaluate_image(const Image& image, const Lesson& lesson,
                                          const std::filesystem::path& root,
                                          Diagnostics& diagnostics);

}  // namespace mjcourse
