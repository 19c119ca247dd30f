#include "process/our_command.h"

#include <cstdlib>

namespace mjcourse {

std::string called_as() {
  const char* const called = std::getenv("MJCOURSE_CALLED");
  return called == nullptr || *called == '\0' ? "mjcourse" : called;
}

std::string our_command(std::string_view words) {
  return ("`" + called_as() + " ").append(words).append("`");
}

}  // namespace mjcourse
