// The lab on a model's page: the model to play with, to push, and to change.
//
// It is written as an author writes a lab, and goes the same way from then on: read, rehearsed with
// every control, shown. Controls under which the model does not stay sound are nobody's mistake
// here: then the lab has none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluate/context/worker_context.h"
#include "evaluate/scenes/model_page.h"
#include "evaluate/scenes/view.h"

namespace mjcourse {

// For `page`, which tells of `model`: a control for each named keyframe and each actuator, a
// reading for each joint of one degree of freedom, up to a handful; and a lab without controls.
std::vector<std::string> model_lab_fences(const ModelPage& page, const Model& model,
                                          const View& view);

// The first of these labs on the page of the model `name` that can be rehearsed. Nothing where not
// even the model alone can.
std::optional<ModelPage::LiveLab> evaluate_model_lab(const std::string& name,
                                                     const std::vector<std::string>& fences,
                                                     WorkerContext& worker_context);

}  // namespace mjcourse
