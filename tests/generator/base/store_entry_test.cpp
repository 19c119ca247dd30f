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

TEST(StoreEntry, SaysWhereItIsFrom) {
  const std::string a(64, 'a'), b(64, 'b');
  Origin both = Origin::signed_by(b);
  both.add(Origin::signed_by(a));
  for (const Origin& origin : {Origin(), Origin::unsigned_one(), both}) {
    const std::string entry = sealed(kAction, Stored{"answer", origin});
    const auto stored = unsealed_stored(kAction, entry);
    ASSERT_TRUE(stored);
    EXPECT_EQ(stored->bytes, "answer");
    EXPECT_EQ(stored->origin, origin);
    EXPECT_FALSE(unsealed_stored("ac/" + sha256("another question"), entry));
    for (std::size_t i = 0; i < entry.size(); ++i) {
      std::string damaged = entry;
      damaged[i] ^= 1;
      EXPECT_FALSE(unsealed_stored(kAction, damaged)) << i;
      EXPECT_FALSE(unsealed_stored(kAction, entry.substr(0, i))) << i;
    }
  }
  EXPECT_EQ(sealed(kBlob, Stored{"bytes", Origin::unsigned_one()}), "bytes");
  EXPECT_EQ(unsealed_stored(kBlob, "bytes")->origin, Origin());
}

// An earlier version does not say so.
TEST(StoreEntry, MayBeFromAnywhere) {
  const auto origin = [](const std::string& name) {
    return unsealed_stored(name, sealed(name, "answer"))->origin;
  };
  EXPECT_EQ(origin(kAction), Origin::unsigned_one());
  EXPECT_EQ(origin("list/" + sha256("a list")), Origin::unsigned_one());
  EXPECT_EQ(origin("here/" + sha256("of this machine")), Origin());
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
  const std::string stored = sealed(kAction, Stored{"answer"});
  EXPECT_TRUE(is_of_another_version(stored)) << "on its way, no entry says where it is from";
  EXPECT_FALSE(is_stored_by_another_version(stored));
  EXPECT_FALSE(is_stored_by_another_version(sealed(kAction, "answer")));
  EXPECT_TRUE(is_stored_by_another_version("mjcourse-store 4 abc"));
}

}  // namespace
}  // namespace mjcourse
