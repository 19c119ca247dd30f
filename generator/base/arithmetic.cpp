#include "base/arithmetic.h"

#include <cmath>
#include <string_view>

#include "base/sha256.h"

namespace mjcourse {
namespace {

std::string features() {
  std::string text;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx")) text += "avx ";
  if (__builtin_cpu_supports("avx2")) text += "avx2 ";
  if (__builtin_cpu_supports("avx512f")) text += "avx512f ";
  if (__builtin_cpu_supports("fma")) text += "fma ";
#endif
  return text;
}

// About one value in a hundred is rounded otherwise by another variant.
std::string rounding() {
  Sha256 hash;
  const auto add = [&](double value) {
    hash.add_raw({reinterpret_cast<const char*>(&value), sizeof value});
  };
  for (int i = 1; i <= 300; ++i) {
    const volatile double x = 0.0173 * i;  // what is known beforehand a compiler would compute
    add(std::sin(x));
    add(std::cos(x));
    add(std::tan(x));
    add(std::atan2(x, 1.7));
    add(std::exp(x));
    add(std::log(x));
    add(std::pow(x, 1.3));
  }
  return hash.hex().substr(0, 16);
}

}  // namespace

const std::string& arithmetic() {
  static const std::string found = features() + rounding();
  return found;
}

}  // namespace mjcourse
