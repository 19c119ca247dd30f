#include "base/folded_name.h"

#include <unicase.h>
#include <uninorm.h>

#include <cstdint>
#include <cstdlib>
#include <memory>

namespace mjcourse {

std::string folded_name(std::string_view name) {
  std::size_t length = 0;
  const std::unique_ptr<std::uint8_t, decltype(&std::free)> folded(
      u8_casefold(reinterpret_cast<const std::uint8_t*>(name.data()), name.size(), "", UNINORM_NFC,
                  nullptr, &length),
      &std::free);
  return folded ? std::string(folded.get(), folded.get() + length) : std::string(name);
}

}  // namespace mjcourse
