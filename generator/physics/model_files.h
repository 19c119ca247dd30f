// The files that a model is made of: what a page must have to compile it as well.
//
// MuJoCo tells no one which files it reads, so this follows the ways in which MJCF names them:
// include, mesh, hfield, texture and skin, and what the compiler's settings do to their paths.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "physics/mistakes/model_error.h"

namespace mjcourse {

// By the last part of their paths, which is what MuJoCo looks files up by where there is no disk;
// the values are paths on the disk.
struct ModelSources {
  std::string main;
  std::map<std::string, std::string> texts;   // MJCF: the main file and its includes
  std::map<std::string, std::string> assets;  // meshes, height fields, textures, skins
};

// Of the model in the file `name` beneath `root`, which compiles; a file that it names and does
// not need is left out. An error where it has two files of one name, or more than MuJoCo can hold
// in memory.
tl::expected<ModelSources, std::string> find_model_sources(const std::filesystem::path& root,
                                                           const std::string& name);

// The files that a model reads, and the first of them that it must not, or cannot.
struct NamedFiles {
  std::vector<std::string> files;  // that are there, the main file first
  std::optional<ModelError> foreign;
  // Where an attribute says `nan` or `inf`; of no harm where that is a name.
  std::optional<ModelError> infinite;
};

// Of the model in the file `name` beneath `course`, which need not compile. Foreign is what lies
// outside of `models`, the first folder of its name, or of `course`, by its name or by a link.
// Foreign too is what is no file but a device or a pipe, is MJCF of many megabytes, is included
// twice, cannot be included, or is what a browser would run.
NamedFiles look_at_model_files(const std::filesystem::path& course, const std::string& name);

// The same of MJCF without a file of its own, which may name none.
NamedFiles look_at_model_text(const std::string& mjcf);

// Whether look_at_model_files() would let a file of this name be an asset.
bool is_name_of_asset(const std::string& name);

// Whether a browser that opens the file `path` beneath `course` would run nothing of it, by what
// look_at_model_files() asks of files that a model names.
bool is_inert(const std::filesystem::path& course, const std::string& path);

// The first file that `mjcf` names, in any of these ways; "" when it names none.
std::string file_named_in(const std::string& mjcf);

}  // namespace mjcourse
