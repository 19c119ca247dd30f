#include "remote/server.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mjcourse {
namespace {

std::string fault_of(const std::string& address) {
  const auto server = server_at(address);
  return server ? "" : server.error();
}

TEST(Server, IsAtAnAddress) {
  EXPECT_EQ(server_at("https://store.example:8080/course/")->url,
            "https://store.example:8080/course");
  EXPECT_EQ(server_at("unix:/run/store.sock")->socket, "/run/store.sock");
}

TEST(Server, IsShownWithoutItsPassword) {
  EXPECT_EQ(server_at("http://ann:secret@store.example/x@y")->shown(), "http://store.example/x@y");
  EXPECT_EQ(server_at("http://store.example/x@y")->shown(), "http://store.example/x@y");
  EXPECT_EQ(server_at("unix:/run/store.sock")->shown(), "unix:/run/store.sock");
}

TEST(Server, SaysWhatIsWrongWithAnAddress) {
  for (const char* address : {"ftp://store.example", "store.example", "", "file:///etc/passwd"}) {
    EXPECT_EQ(fault_of(address),
              "the address of a shared store begins with http://, https:// or unix:/")
        << address;
  }
  EXPECT_EQ(fault_of("unix:store"), "the address of a shared store has a / behind unix:");
  EXPECT_EQ(fault_of("http://"), "the address of a shared store names a host");
  EXPECT_EQ(fault_of("http:///path"), "the address of a shared store names a host");
  EXPECT_EQ(fault_of("http://store.example/?x=1"),
            "the address of a shared store is a folder's, without ? and #");
  EXPECT_EQ(fault_of("http://store.example/\r\nHost: other"),
            "the address of a shared store has no blanks, quotes or brackets");
}

TEST(Server, TrustsNobodyByAnEmptyList) {
  for (const char* empty : {"", ",", " \n"}) {
    setenv("MJCOURSE_STORE_TRUSTED_KEYS", empty, 1);
    EXPECT_EQ(fault_of("http://store.example"),
              "MJCOURSE_STORE_TRUSTED_KEYS lists no key; unset it to trust everybody");
  }
  const std::string key(64, '0');
  setenv("MJCOURSE_STORE_TRUSTED_KEYS", (key + ", " + key).c_str(), 1);
  EXPECT_EQ(server_at("http://store.example")->trusted_keys, (std::vector<std::string>{key, key}));
  unsetenv("MJCOURSE_STORE_TRUSTED_KEYS");
}

TEST(Server, TakesNoTokenThatEndsAHeader) {
  setenv("MJCOURSE_STORE_TOKEN", "a\nX-Other: b", 1);
  EXPECT_EQ(fault_of("http://store.example"),
            "MJCOURSE_STORE_TOKEN has a character that no token has");
  setenv("MJCOURSE_STORE_TOKEN", "abc=", 1);
  EXPECT_EQ(server_at("http://store.example")->token, "abc=");
  unsetenv("MJCOURSE_STORE_TOKEN");
}

}  // namespace
}  // namespace mjcourse
