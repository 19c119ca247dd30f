// The home page: the course's lessons, each as a card.
#pragma once

#include <string>

#include "evaluate/evaluate.h"
#include "page/page_writer.h"

namespace mjcourse {

// Its body.
std::string home_page(const Course& course, const Evaluation& evaluation, const Press& press);

}  // namespace mjcourse
