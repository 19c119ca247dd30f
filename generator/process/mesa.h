// How Mesa draws, for us and for the lessons' programs that draw: it is told by environment
// variables.
//
// The shaders that it compiles are kept with what else we cache, and not in a folder of its own. A
// first picture takes 0.3 s of CPU instead of 0.6 with them. Each thread that draws does it on its
// own thread: there are as many that draw, or compile, as the processor has cores, and to share a
// picture among threads costs a tenth of it. Enter with set_up_mesa(), once, and lend_shaders_to()
// for each program.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

// Before the first Renderer, and before there are threads: sets what the user did not. Without a
// `cache` Mesa chooses where to keep shaders.
void set_up_mesa(const std::optional<std::filesystem::path>& cache);

// Where a program reads what Mesa has compiled for us, and where it keeps what it compiles itself.
struct LentShaders {
  std::filesystem::path ours, own;     // `ours` is empty where none are kept
  std::vector<std::string> variables;  // "NAME=value", for the program's environment
};

// Makes `own` in `folder`, with links to the shaders in `ours`. As what a program adds stays there,
// it cannot change the pictures of another.
LentShaders lend_shaders_to(const std::filesystem::path& folder);

}  // namespace mjcourse
