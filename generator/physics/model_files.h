// The files that a model is made of: what a page must have to compile it as well.
//
// MuJoCo tells no one which files it reads, so this follows the ways in which MJCF names them:
// include, mesh, hfield, texture and skin, and what the compiler's settings do to their paths.
#pragma once

#include <map>
#include <string>
#include <tl/expected.hpp>

namespace mjcourse {

// By the last part of their paths, which is what MuJoCo looks files up by where there is no disk;
// the values are paths on the disk.
struct ModelSources {
  std::string main;
  std::map<std::string, std::string> texts;   // MJCF: the main file and its includes
  std::map<std::string, std::string> assets;  // meshes, height fields, textures, skins
};

// Of the model in the file at `path`, which compiles; a file that it names and does not need is
// left out. An error where it has two files of one name, or more than MuJoCo can hold in memory.
tl::expected<ModelSources, std::string> find_model_sources(const std::string& path);

// The first file that `mjcf` names, in any of these ways; "" when it names none.
std::string file_named_in(const std::string& mjcf);

}  // namespace mjcourse
