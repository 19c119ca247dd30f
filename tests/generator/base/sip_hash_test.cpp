#include "base/sip_hash.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

// Of the paper's key, 00 01 02 … 0f, and the bytes 00 01 02 …: the reference's first and last ones,
// and that of the paper's appendix.
TEST(SipHash, IsThatOfItsAuthors) {
  const SipKey key{0x0706050403020100u, 0x0f0e0d0c0b0a0908u};
  std::string bytes;
  for (int i = 0; i < 63; ++i) bytes += static_cast<char>(i);
  EXPECT_EQ(sip_hash(key, bytes.data(), 0), 0x726fdb47dd0e0e31u);
  EXPECT_EQ(sip_hash(key, bytes.data(), 1), 0x74f839c593dc67fdu);
  EXPECT_EQ(sip_hash(key, bytes.data(), 8), 0x93f5f5799a932462u);
  EXPECT_EQ(sip_hash(key, bytes.data(), 15), 0xa129ca6149be45e5u);
  EXPECT_EQ(sip_hash(key, bytes.data(), 63), 0x958a324ceb064572u);
}

}  // namespace
}  // namespace mjcourse
