// SipHash-2-4 (Aumasson and Bernstein, 2012): a hash of bytes under a key, of 64 bits. Nobody who
// lacks the key can make one, or learn it from others.
//
// The text of this file also goes into programs (evaluate/programs/judged_text.cpp), so it
// includes the standard library alone.
// Tested by tests/generator/base/sip_hash_test.cpp.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace mjcourse {

struct SipKey {
  std::uint64_t first = 0, second = 0;
};

inline void sip_round(std::uint64_t (&v)[4]) {
  v[0] += v[1];
  v[1] = std::rotl(v[1], 13) ^ v[0];
  v[0] = std::rotl(v[0], 32);
  v[2] += v[3];
  v[3] = std::rotl(v[3], 16) ^ v[2];
  v[0] += v[3];
  v[3] = std::rotl(v[3], 21) ^ v[0];
  v[2] += v[1];
  v[1] = std::rotl(v[1], 17) ^ v[2];
  v[2] = std::rotl(v[2], 32);
}

inline std::uint64_t sip_hash(const SipKey& key, const char* bytes, std::size_t size) {
  std::uint64_t v[4] = {key.first ^ 0x736f6d6570736575u, key.second ^ 0x646f72616e646f6du,
                        key.first ^ 0x6c7967656e657261u, key.second ^ 0x7465646279746573u};
  for (std::size_t begin = 0; begin <= size; begin += 8) {
    // Eight bytes, the first the lowest; the last of all has the size in its highest.
    std::uint64_t word = begin + 8 > size ? std::uint64_t{size} << 56 : 0;
    for (std::size_t i = 0; i < 8 && begin + i < size; ++i) {
      word |= std::uint64_t{static_cast<unsigned char>(bytes[begin + i])} << (8 * i);
    }
    v[3] ^= word;
    for (int round = 0; round < 2; ++round) sip_round(v);
    v[0] ^= word;
  }
  v[2] ^= 0xff;
  for (int round = 0; round < 4; ++round) sip_round(v);
  return v[0] ^ v[1] ^ v[2] ^ v[3];
}

}  // namespace mjcourse
