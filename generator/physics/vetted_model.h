// Models that somebody else wrote, loaded only when they do no harm.
//
// MuJoCo works in our own process: it reads whatever file a model names, and takes the memory that
// a size asks for. So first the files are looked at, which must be files, and lie where models do;
// then a child loads the model and moves it a step, within limits. What passes is loaded as
// model.h does, and what is wrong with it is said in the same way. Any thread may load while others
// do.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "physics/model.h"

namespace mjcourse {

// The model in the file `name` beneath `root`; all its files lie in the first folder of that.
tl::expected<Model, ModelError> load_vetted_file(const std::filesystem::path& root,
                                                 const std::string& name);

// The model that `mjcf` describes; it names no files.
tl::expected<Model, ModelError> load_vetted_text(const std::string& mjcf);

}  // namespace mjcourse
