// Finding out what the page of a model tells, `[text](model:joint_zoo)`.
#pragma once

#include <optional>

#include "evaluate/context/block_context.h"
#include "findings/model_page.h"

namespace mjcourse {

// Of the course's model `name`, which a page links to there. Nothing (reported) where it has none.
std::optional<ModelPage> evaluate_model_page(const LocatedText& name, const BlockContext& context);

}  // namespace mjcourse
