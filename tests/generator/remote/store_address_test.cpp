#include "remote/store_address.h"

#include <curl/curl.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace mjcourse {
namespace {

std::string fault_in(const std::string& address) {
  const auto read = read_store_address(address);
  return read ? "" : read.error();
}

constexpr const char* kAnotherAt =
    "the address of a shared store has no @ but the one that ends its name and password: write any "
    "other as %40, and in these two / as %2F, ? as %3F and # as %23, or put them into ~/.netrc, or "
    "a token into MJCOURSE_STORE_TOKEN";

TEST(StoreAddress, HasParts) {
  const StoreAddress all = read_store_address("https://ann:pa%2Fss@store.example:80/x/").value();
  EXPECT_EQ(all.url, "https://store.example:80/x");
  EXPECT_EQ(all.user, "ann");
  EXPECT_EQ(all.password, "pa%2Fss");
  const StoreAddress plain = read_store_address("http://[::1]:8080//").value();
  EXPECT_EQ(plain.url, "http://[::1]:8080");
  EXPECT_EQ(plain.user + plain.password, "");
  EXPECT_EQ(read_store_address("https://token@h")->user, "token");
  EXPECT_EQ(read_store_address("unix:/run/store.sock")->socket, "/run/store.sock");
}

TEST(StoreAddress, HasAHostAndAPort) {
  const auto place = [](const std::string& address) {
    const StoreAddress read = read_store_address(address).value();
    return read.host() + " " + std::to_string(read.port());
  };
  EXPECT_EQ(place("http://ann:b@store.example/x:1"), "store.example 80");
  EXPECT_EQ(place("https://store.example"), "store.example 443");
  EXPECT_EQ(place("https://[::1]"), "::1 443");
  EXPECT_EQ(place("http://[::1]:8080/x"), "::1 8080");
}

TEST(StoreAddress, IsShownWithoutItsPassword) {
  const auto shown = [](const std::string& address) {
    return read_store_address(address)->shown();
  };
  EXPECT_EQ(shown("http://ann:secret@store.example/x%40y"), "http://store.example/x%40y");
  EXPECT_EQ(shown("http://ann:pa%2Fss@store.example"), "http://store.example");
  EXPECT_EQ(shown("http://store.example/x"), "http://store.example/x");
  EXPECT_EQ(shown("unix:/run/a@b.sock"), "unix:/run/a@b.sock");
}

// Each may be one of an address without a password, for another reader than the user.
TEST(StoreAddress, HasNoPasswordThatEndsTooEarly) {
  for (const char* address :
       {"https://user:pa/ss@host/", "https://user:12/ss@host/", "https://user:pa?ss@host/",
        "https://user:pa#ss@host/", "https://user:pa@ss@host/", "https://to/ken@host/",
        "https://user:p@a/ss@host/", "https://host/a@b", "https:///ss@host", "https://@@host"}) {
    EXPECT_EQ(fault_in(address), kAnotherAt) << address;
  }
  for (const char* address : {"https://a:%2@host", "https://a:%zz@host", "https://a:%0a@host",
                              "https://a:%00@host", "https://%1F@host", "https://a:100%@host"}) {
    EXPECT_EQ(fault_in(address),
              "the address of a shared store has %25 for a % in its name or password")
        << address;
  }
}

TEST(StoreAddress, NamesAHost) {
  for (const char* address : {"http://", "http:///path", "http://a:b@", "https://:80/"}) {
    EXPECT_EQ(fault_in(address), "the address of a shared store names a host") << address;
  }
  for (const char* address : {"http://a%2eb/", "http://[::1/", "http://a]b", "http://[]",
                              "http://a,b", "http://a&b", "http://[::1]x", "http://[a;b]"}) {
    EXPECT_EQ(fault_in(address),
              "the address of a shared store has a character in its host that no name of one has")
        << address;
  }
  for (const char* address :
       {"http://user:pa/ss", "http://h:", "http://h:0", "http://h:65536", "http://h:8080x",
        "http://h:-1", "http://h:80:80", "http://[::1]:x"}) {
    EXPECT_EQ(
        fault_in(address),
        "the address of a shared store has a number from 1 to 65535 behind the colon of its host")
        << address;
  }
}

TEST(StoreAddress, IsOfOneKind) {
  for (const char* address : {"ftp://store.example", "store.example", "", "file:///etc/passwd",
                              "HTTP://store.example", "http:/store.example", "//h"}) {
    EXPECT_EQ(fault_in(address),
              "the address of a shared store begins with http://, https:// or unix:/")
        << address;
  }
  EXPECT_EQ(fault_in("unix:store"), "the address of a shared store has a / behind unix:");
  for (const char* address : {"http://store.example/?x=1", "http://h#x", "http://h/x#y?z"}) {
    EXPECT_EQ(fault_in(address), "the address of a shared store is a folder's, without ? and #")
        << address;
  }
  for (const char* address : {"http://store.example/\r\nHost: other", "http://a b", "http://h/\x7f",
                              "http://a\x01"
                              "b@h",
                              "http://h/\\x", "http://{h}", "unix:/a b"}) {
    EXPECT_EQ(fault_in(address), "the address of a shared store has no blanks, quotes or brackets")
        << address;
  }
}

// The part of an address, as libcurl reads it; empty where there is none.
std::string libcurl_part(const std::string& address, CURLUPart part) {
  const std::unique_ptr<CURLU, decltype(&curl_url_cleanup)> url(curl_url(), curl_url_cleanup);
  EXPECT_EQ(curl_url_set(url.get(), CURLUPART_URL, address.c_str(), 0), CURLUE_OK) << address;
  char* text = nullptr;
  if (curl_url_get(url.get(), part, &text, 0) != CURLUE_OK) return "";
  std::string copy = text;
  curl_free(text);
  return copy;
}

// libcurl is asked with what is shown: at the same host, and with no password in it.
TEST(StoreAddress, IsReadByLibcurlAlike) {
  const std::vector<std::string> pieces{"",  "a",   ":8", ":",     "@", "/",  "?",
                                        "#", "%41", "%",  "[::1]", ".", "..", "&"};
  constexpr std::size_t length = 4;
  std::size_t accepted = 0, all = 1;
  for (std::size_t i = 0; i < length; ++i) all *= pieces.size();
  for (std::size_t number = 0; number < all; ++number) {
    std::string text = "http://";
    for (std::size_t i = 0, rest = number; i < length; ++i, rest /= pieces.size()) {
      text += pieces[rest % pieces.size()];
    }
    const auto read = read_store_address(text);
    if (!read) continue;
    ++accepted;
    EXPECT_EQ(libcurl_part(read->url, CURLUPART_USER), "") << text;
    EXPECT_EQ(libcurl_part(read->url, CURLUPART_PASSWORD), "") << text;
    const std::string place = read->url.substr(7, read->url.find('/', 7) - 7);
    const std::string port = libcurl_part(read->url, CURLUPART_PORT);
    const std::string host = libcurl_part(read->url, CURLUPART_HOST);
    EXPECT_EQ(host + (port.empty() ? "" : ":" + port), place) << text;
  }
  EXPECT_GT(accepted, 500u);
}

TEST(StoreAddress, IsLeftOutOfWhatIsRepeated) {
  EXPECT_EQ(without_userinfo("not https://user:pa/ss@host/x"), "not https://…@host/x");
  EXPECT_EQ(without_userinfo("not https://host/x"), "not https://host/x");
  EXPECT_EQ(without_userinfo("a@b"), "a@b");
  EXPECT_EQ(without_userinfo("a@b://"), "a@b://");
}

}  // namespace
}  // namespace mjcourse
