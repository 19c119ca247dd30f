// The page of a model: a picture of it, what it is made of, its MJCF to read and to take away.
// Tested by tests/site/checks/references.mjs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "findings/evaluation.h"
#include "page/blocks/page_writer.h"
#include "page/html/still_data.h"

namespace mjcourse {

struct ModelPageHtml {
  std::string body;
  std::vector<LabFiles> lab_files;  // what its lab needs beside it
};

// `context` is that of models/NAME.html.
ModelPageHtml model_page(const ModelPage& model, const Course& course, const Evaluation& evaluation,
                         const PageContext& context);

// The model's picture, as picture.hbs wants it, and its sizes; `root` is the way to the site's
// root.
nlohmann::json poster_data(const ModelPage& model, const std::string& root, Loaded loaded);
nlohmann::json sizes_data(const ModelPage& model);

// Where the model's picture lies, below the site's root and without the extension.
std::string model_poster_path(const ModelPage& model);

}  // namespace mjcourse
