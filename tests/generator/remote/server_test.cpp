#include "remote/server.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "base/temporary_folder.h"

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
    // Nothing in it would stand for: not set.
    setenv(name.c_str(), "/dev/null", 1);
    EXPECT_EQ(fault_of("http://store.example"), name + " does not name a file that can be read");
    setenv(name.c_str(), "", 1);
    EXPECT_EQ(fault_of("http://store.example"), "");
    unsetenv(name.c_str());
  }
}

TEST(Server, HasThePasswordOfNetrc) {
  const TemporaryFolder home;
  write_file(home.path() / ".netrc",
             "machine store.example login ann password a@1\n"
             "machine store.example login bob password b2\n");
  const char* const before = getenv("HOME");
  const std::string kept = before == nullptr ? "" : before;
  setenv("HOME", home.path().c_str(), 1);
  const auto login = [](const std::string& address) {
    const StoreAddress read = server_at(address)->address;
    return read.user + ":" + read.password;
  };
  EXPECT_EQ(login("https://store.example:80/x"), "ann:a%401");
  EXPECT_EQ(login("https://bob@store.example"), "bob:b2");
  EXPECT_EQ(login("https://cid@store.example"), "cid:");
  EXPECT_EQ(login("https://bob:own@store.example"), "bob:own");
  EXPECT_EQ(login("https://other.example"), ":");
  setenv("MJCOURSE_STORE_TOKEN", "token", 1);
  EXPECT_EQ(login("https://store.example"), ":");
  unsetenv("MJCOURSE_STORE_TOKEN");
  setenv("HOME", kept.c_str(), 1);
}

// As for curl. A file of our own variable comes first.
TEST(Server, TrustsWhomAFileSays) {
  const TemporaryFolder folder;
  write_file(folder.path() / "all", "all");
  write_file(folder.path() / "ours", "ours");
  setenv("SSL_CERT_FILE", (folder.path() / "all").c_str(), 1);
  EXPECT_EQ(server_at("https://store.example")->authorities, "all");
  setenv("MJCOURSE_STORE_AUTHORITIES", (folder.path() / "ours").c_str(), 1);
  EXPECT_EQ(server_at("https://store.example")->authorities, "ours");
  unsetenv("MJCOURSE_STORE_AUTHORITIES");
  unsetenv("SSL_CERT_FILE");
  EXPECT_EQ(server_at("https://store.example")->authorities, "");
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
