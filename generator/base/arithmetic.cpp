#include "base/arithmetic.h"

#include <sys/utsname.h>

namespace mjcourse {

const std::string& arithmetic() {
  static const std::string found = [] {
    utsname system{};
    uname(&system);
    return std::string(system.machine) + " " + kOneRounding;
  }();
  return found;
}

const std::string& processor_features() {
  static const std::string found = [] {
    std::string text;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx")) text += "avx ";
    if (__builtin_cpu_supports("avx2")) text += "avx2 ";
    if (__builtin_cpu_supports("avx512f")) text += "avx512f ";
    if (__builtin_cpu_supports("fma")) text += "fma ";
#endif
    return text.empty() ? text : text.substr(0, text.size() - 1);
  }();
  return found;
}

}  // namespace mjcourse
