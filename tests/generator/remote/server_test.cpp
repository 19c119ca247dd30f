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
  EXPECT_EQ(server_at("https://store.example:8080/course/")->address.url,
            "https://store.example:8080/course");
  EXPECT_EQ(fault_of("store"),
            "the address of a shared store begins with http://, https:// or unix:/");
}

// A variable may hold the secret itself, where it should name a file of it.
TEST(Server, RepeatsNothingOfItsVariables) {
  for (const std::string name : {"MJCOURSE_STORE_CERTIFICATE", "MJCOURSE_STORE_KEY",
                                 "MJCOURSE_STORE_AUTHORITIES", "MJCOURSE_STORE_SIGNING_KEY"}) {
    for (const char* value :
         {"mjcourse-signing-key 00", "-----BEGIN PRIVATE KEY-----\nMIIE", "/none"}) {
      setenv(name.c_str(), value, 1);
      EXPECT_EQ(fault_of("http://store.example"), name + " does not name a file that can be read");
    }
    setenv(name.c_str(), "", 1);
    EXPECT_EQ(fault_of("http://store.example"), "");
    unsetenv(name.c_str());
  }
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
  for (const char* token : {"a\nX-Other: b", "a b", "a\r", "\x01", "\x7f", "\xc3\xa4"}) {
    setenv("MJCOURSE_STORE_TOKEN", token, 1);
    EXPECT_EQ(fault_of("http://store.example"),
              "MJCOURSE_STORE_TOKEN has a character that no token has");
  }
  setenv("MJCOURSE_STORE_TOKEN", "abc=", 1);
  EXPECT_EQ(server_at("http://store.example")->token, "abc=");
  unsetenv("MJCOURSE_STORE_TOKEN");
}

}  // namespace
}  // namespace mjcourse
