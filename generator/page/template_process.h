// The templates of a course's theme, rendered in a process of their own.
//
// They may be a stranger's, and an engine that renders them takes what memory they ask for. So the
// same program is started once more, confined as a worker is (evaluate/worker.h), with nothing of
// the course in reach, and asked for one piece of a page after the other.
// Tested by tests/system/themed.mjs.
#pragma once

#include <filesystem>

#include "base/files.h"
#include "page/blocks/page_writer.h"
#include "page/blocks/themed_assets.h"

namespace mjcourse {

// The command that has the program render, before the assets' folder.
inline constexpr const char* kRenderCommand = "--render";

// Who renders the templates of `themed`: such a process, where the course has some of its own. It
// is the `program`, the generator's own file, with `assets`, the folder of what the site's build
// made; both are absolute. Without a program, they are rendered in this process.
RendererOf renderer_of(const ThemedAssets& themed, const std::filesystem::path& program,
                       const std::filesystem::path& assets);

// What that process does: until stdin ends.
void render_templates(const Files& assets);

}  // namespace mjcourse
