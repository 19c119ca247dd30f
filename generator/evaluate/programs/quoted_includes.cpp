#include "evaluate/programs/quoted_includes.h"

#include <re2/re2.h>

namespace mjcourse {

std::vector<std::string> quoted_includes(std::string_view program) {
  static const RE2 form(R"re((?m)^[ \t]*#[ \t]*include[ \t]*"([^"\n]+)")re");
  re2::StringPiece rest(program.data(), program.size());
  std::vector<std::string> names;
  for (std::string name; RE2::FindAndConsume(&rest, form, &name);) names.push_back(name);
  return names;
}

}  // namespace mjcourse
