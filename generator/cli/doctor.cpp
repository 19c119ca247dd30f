// `mjcourse doctor`: a line for each thing that courses need, and the cure of what is not well.
#include <algorithm>
#include <iostream>

#include "base/counted.h"
#include "cli/checkup.h"
#include "cli/commands.h"
#include "cli/run.h"
#include "cli/verify.h"

namespace mjcourse {
namespace {

const char* word_for(Sign::Grade grade) {
  if (grade == Sign::Grade::good) return "ok    ";
  return grade == Sign::Grade::slow ? "note  " : "FAIL  ";
}

}  // namespace

int doctor(const DoctorOptions& options) {
  std::vector<Sign> signs = examine(assets_folder(), store_folder(options.store));
  if (auto shared = examine_shared(assets_folder(), options.shared)) {
    signs.push_back(*std::move(shared));
  }
  std::ptrdiff_t missing = 0;
  std::cout << "mjcourse " MJCOURSE_VERSION "\n";
  for (const Sign& sign : signs) {
    std::cout << word_for(sign.grade) << sign.of << std::string(10 - sign.of.size(), ' ')
              << sign.state << '\n';
    if (!sign.cure.empty()) std::cout << "      cure: " << sign.cure << '\n';
    missing += sign.grade == Sign::Grade::missing ? 1 : 0;
  }
  std::cout << (missing == 0 ? "all that courses need is here"
                             : counted(missing, "thing") + " that courses need " +
                                   (missing == 1 ? "is" : "are") + " missing")
            << '\n';
  return missing == 0 ? kClean : kCourseErrors;
}

}  // namespace mjcourse
