// Finding: what one piece of work found out.
#pragma once

#include <cstddef>
#include <map>
#include <optional>

#include "findings/model_page.h"
#include "findings/result.h"
#include "report/diagnostic.h"

namespace mjcourse {

struct Finding {
  std::map<std::size_t, Result> results;  // by the lesson's blocks; only what came out well
  std::map<std::size_t, double> seconds;  // measured, of these
  std::map<std::size_t, PageRun> pages;   // what the programs of these blocks are in the page
  double work = 0;                        // measured: of all that was done for it
  std::optional<ModelPage> model_page;
  Diagnostics diagnostics;
};

}  // namespace mjcourse
