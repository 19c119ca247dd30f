#include "base/store_entry.h"

#include <gtest/gtest.h>

#include "base/sha256.h"

namespace mjcourse {
namespace {

const std::string kBlob = "cas/" + sha256("bytes"), kAction = "ac/" + sha256("a question");

TEST(StoreEntry, HasBytesUnderTheirHashAsTheyAre) {
  EXPECT_EQ(sealed(kBlob, "bytes"), "bytes");
  EXPECT_EQ(unsealed(kBlob, "bytes"), "bytes");
  EXPECT_EQ(unsealed(kBlob, "byte"), std::nullopt);
}

TEST(StoreEntry, SealsAllOthersWithTheirName) {
  const std::string entry = sealed(kAction, "answer");
  EXPECT_EQ(unsealed(kAction, entry), "answer");
  for (const char* kind : {"list/", "here/"}) {
    EXPECT_EQ(unsealed(kind + sha256("a question"), entry), std::nullopt) << kind;
  }
  for (std::size_t i = 0; i < entry.size(); ++i) {
    std::string damaged = entry;
    damaged[i] ^= 1;
    EXPECT_EQ(unsealed(kAction, damaged), std::nullopt) << i;
    EXPECT_EQ(unsealed(kAction, entry.substr(0, i)), std::nullopt) << i;
  }
}

TEST(StoreEntry, KnowsItsNames) {
  const std::string hash = sha256("");
  for (const char* kind : {"cas/", "ac/", "list/", "here/"}) {
    EXPECT_TRUE(is_store_name(kind + hash));
    EXPECT_FALSE(is_store_name(kind + hash.substr(1)));
    EXPECT_FALSE(is_store_name(kind + std::string(64, 'g')));
  }
  EXPECT_FALSE(is_store_name("tmp/" + hash));
  EXPECT_FALSE(is_store_name(hash));
}

TEST(StoreEntry, KnowsThoseOfOtherVersions) {
  EXPECT_TRUE(is_of_another_version("mjcourse-store 1 abc"));
  EXPECT_FALSE(is_of_another_version(sealed(kAction, "answer")));
  EXPECT_FALSE(is_of_another_version("<html>"));
}

}  // namespace
}  // namespace mjcourse
