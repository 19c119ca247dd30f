#include "remote/netrc.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// "name password", or "none".
std::string found(std::string_view netrc, std::string_view host, std::string_view user = "") {
  const auto login = login_in(netrc, host, user);
  return login ? login->user + " " + login->password : "none";
}

TEST(Netrc, HasLoginsByHosts) {
  const std::string text =
      "machine one.example login ann password a1\n"
      "machine two.example\n\tlogin bob\n\tpassword b2\n";
  EXPECT_EQ(found(text, "one.example"), "ann a1");
  EXPECT_EQ(found(text, "TWO.example"), "bob b2");
  EXPECT_EQ(found(text, "two.example.org"), "none");
  EXPECT_EQ(found("", "two.example"), "none");
}

TEST(Netrc, HasSeveralOfAHost) {
  const std::string text =
      "machine h login ann password a1\nmachine h login bob password b2\n"
      "machine h password c3 login cid\n";
  EXPECT_EQ(found(text, "h"), "ann a1");
  EXPECT_EQ(found(text, "h", "bob"), "bob b2");
  EXPECT_EQ(found(text, "h", "cid"), "cid c3");
  EXPECT_EQ(found(text, "h", "dan"), "none");
}

TEST(Netrc, MayHaveOneForAllHosts) {
  const std::string text = "machine h login ann password a1\ndefault login any password x\n";
  EXPECT_EQ(found(text, "h"), "ann a1");
  EXPECT_EQ(found(text, "other"), "any x");
}

TEST(Netrc, HasCommentsMacrosAndQuotes) {
  EXPECT_EQ(found("# machine h login no password no\nmachine h login a password b # c\n", "h"),
            "a b");
  EXPECT_EQ(
      found("macdef m\nmachine h login no password no\n\nmachine h login a password b\n", "h"),
      "a b");
  EXPECT_EQ(found(R"(machine h login "a b" password "c\"d\\e\nf#")", "h"), "a b c\"d\\e\nf#");
  EXPECT_EQ(found("machine h login a account x password b", "h"), "a b");
}

TEST(Netrc, MayEndAnywhere) {
  const std::string text = "machine h login \"a\\\" b\" password \"b\"\n";
  for (std::size_t size = 0; size < text.size() - 3; ++size) {
    EXPECT_EQ(found(text.substr(0, size), "h"), "none") << size;
  }
  EXPECT_EQ(found(text, "h"), "a\" b b");
}

}  // namespace
}  // namespace mjcourse
