// A program to take along: a folder with all that builds and runs it, wherever MuJoCo and Eigen are
// installed. Its models are found beside it, so nothing need be set.
#pragma once

#include <map>
#include <string>

#include "page/site_data.h"

namespace mjcourse {

struct TakenProgram {
  const Example& example;
  const ExampleResult& result;
  const Lesson& lesson;   // to which it belongs
  std::string text = {};  // "" where it is that of the example's file
};

// The files by their paths, of which all begin with the program's name. Throws std::runtime_error
// where one is gone that was there when the program ran.
std::map<std::string, std::string> program_folder(const TakenProgram& program,
                                                  const SiteData& site);

}  // namespace mjcourse
