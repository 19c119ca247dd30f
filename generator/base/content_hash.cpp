#include "base/content_hash.h"

#include <cstdint>

namespace mjcourse {

std::string content_hash(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : content) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  std::string name(10, '0');
  for (char& c : name) {
    c = "0123456789abcdefghijklmnopqrstuvwxyz"[hash % 36];
    hash /= 36;
  }
  return name;
}

}  // namespace mjcourse
