#include "base/blob.h"

#include <gtest/gtest.h>

#include "base/sha256.h"
#include "memory_store.h"

namespace mjcourse {
namespace {

TEST(Blob, IsKnownByItsHash) {
  const Blob blob("bytes");
  EXPECT_EQ(blob.hash(), sha256("bytes"));
  EXPECT_EQ(blob.bytes(), "bytes");
  EXPECT_FALSE(blob.empty());
}

TEST(Blob, OfNoBytesIsEmpty) {
  for (const Blob& blob : {Blob(), Blob("")}) {
    EXPECT_TRUE(blob.empty());
    EXPECT_EQ(blob.hash(), "");
    EXPECT_EQ(blob.bytes(), "");
  }
}

TEST(Blob, IsReadFromTheStoreThatKeepsIt) {
  MemoryStore store;
  Blob blob("bytes");
  ASSERT_TRUE(blob.keep_in(store));
  EXPECT_EQ(blob.bytes(), "bytes");
  Blob again = Blob::known(blob.hash());
  EXPECT_FALSE(again.empty());
  ASSERT_TRUE(again.keep_in(store));
  EXPECT_EQ(again.bytes(), "bytes");
}

TEST(Blob, IsNotKeptWhereTheStoreLacksIt) {
  MemoryStore store;
  EXPECT_FALSE(Blob::known(sha256("bytes")).keep_in(store));
  Blob none;
  EXPECT_TRUE(none.keep_in(store));
  EXPECT_EQ(none.bytes(), "");
}

}  // namespace
}  // namespace mjcourse
