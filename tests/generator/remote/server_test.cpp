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
    EXPECT_EQ(fault_of(address), "it must begin with http://, https:// or unix:/") << address;
  }
  EXPECT_EQ(fault_of("unix:store"), "its path must begin with /");
  EXPECT_EQ(fault_of("http://"), "it names no host");
  EXPECT_EQ(fault_of("http:///path"), "it names no host");
  EXPECT_EQ(fault_of("http://store.example/?x=1"), "it is a folder's, and has no ? or #");
  EXPECT_EQ(fault_of("http://store.example/\r\nHost: other"),
            "it has a character that no address has");
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
