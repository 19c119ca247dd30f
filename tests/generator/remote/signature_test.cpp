#include "remote/signature.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

SigningKey key_of(const std::string& digits) {
  const TemporaryFolder folder;
  write_file(folder.path() / "key", "mjcourse-signing-key " + digits + "\n");
  return SigningKey::read(folder.path() / "key").value();
}

// RFC 8032, section 7.1, test 2: a message of one byte, 0x72.
TEST(Signature, IsEd25519) {
  const SigningKey key = key_of("4ccd089b28ff96da9db6c346ec114e0f5b8a319f35aba624da8cf6ed4fb8a6fb");
  EXPECT_EQ(key.public_key(), "3d4017c3e843895a92b70aa74d1b7ebc9c982ccf2ec4968cc0cd55f12af4660c");
  EXPECT_EQ(key.signature("\x72"),
            "92a009a9f0d4cab8720e820b5f642540a2b27b5416503f8fb3762223ebdb69da"
            "085ac1e43e15996e458f3613d0f11d8c387b2eaeb4302aeeb00d291612bb0c00");
}

TEST(Signature, IsOfOneTextByOneKey) {
  const SigningKey key = SigningKey::random(), other = SigningKey::random();
  const std::string signature = key.signature("a result");
  EXPECT_TRUE(has_signed(key.public_key(), "a result", signature));
  EXPECT_FALSE(has_signed(key.public_key(), "another result", signature));
  EXPECT_FALSE(has_signed(other.public_key(), "a result", signature));
  for (std::size_t i = 0; i < signature.size(); ++i) {
    std::string changed = signature;
    changed[i] = changed[i] == '0' ? '1' : '0';
    EXPECT_FALSE(has_signed(key.public_key(), "a result", changed)) << i;
  }
  for (const std::string none : {"", "00", "zz"}) {
    EXPECT_FALSE(has_signed(key.public_key(), "a result", none));
    EXPECT_FALSE(has_signed(none, "a result", signature));
  }
}

TEST(Signature, HasAKeyThatAFileKeeps) {
  const TemporaryFolder folder;
  const SigningKey key = SigningKey::random();
  write_file(folder.path() / "key", key.file());
  EXPECT_EQ(SigningKey::read(folder.path() / "key")->public_key(), key.public_key());
  EXPECT_TRUE(is_public_key(key.public_key()));
  EXPECT_FALSE(is_public_key(key.public_key() + "0"));

  const std::string nowhere = (folder.path() / "nowhere").string();
  EXPECT_EQ(SigningKey::read(nowhere).error(), nowhere + " cannot be read");
  for (const std::string text :
       {"", "mjcourse-signing-key 00\n", "-----BEGIN PRIVATE KEY-----\n"}) {
    write_file(folder.path() / "key", text);
    EXPECT_EQ(SigningKey::read(folder.path() / "key").error(),
              (folder.path() / "key").string() + " is not a key that `mjcourse store key` made");
  }
}

}  // namespace
}  // namespace mjcourse
