#include "course/web_address.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

// What is underlined, and why; "" where there is no fault.
std::string told(const std::string& address, const std::optional<AddressFault>& fault) {
  if (!fault) return "";
  return "<" + address.substr(fault->begin, fault->end - fault->begin) + "> " + fault->message;
}

std::string site(const std::string& address) {
  return told(address, site_address_fault(address));
}

std::string edit(const std::string& address) {
  return told(address, edit_address_fault(address));
}

TEST(WebAddress, TakesThoseOfSites) {
  for (const char* good : {"https://example.org", "https://example.org/",
                           "http://localhost:8000/a/b", "https://me.codeberg.page/c%20d/~x/",
                           "HTTPS://example.org/", "https://xn--bcher-kva.example/@me/"}) {
    EXPECT_EQ(site(good), "") << good;
  }
}

TEST(WebAddress, UnderlinesWhatIsWrong) {
  EXPECT_EQ(site("example.org/course"),
            "<example.org/course> `example.org/course` is not a web address");
  EXPECT_EQ(site("ftp://example.org"),
            "<ftp://example.org> `ftp://example.org` is not a web address");
  for (const char* host : {"me@example.org", "exa mple.org", "-x.org", ".org", "a..b", "a:", "a:0",
                           "a:65536", "b\xC3\xBC.org"}) {
    EXPECT_EQ(site(std::string("https://") + host + "/x"),
              "<" + std::string(host) + "> the address names no host here");
  }
  EXPECT_EQ(site("https:///x"), "</> the address names no host here");
  EXPECT_EQ(site("https://a.org/b c"), "< > an address cannot have this character");
  EXPECT_EQ(site("https://a.org/\"><b"), "<\"> an address cannot have this character");
  EXPECT_EQ(site("https://a.org/%2"), "<%> an address cannot have this character");
  EXPECT_EQ(site("https://a.org/%zz"), "<%> an address cannot have this character");
  EXPECT_EQ(site("https://a.org/x?y=1#z"),
            "<?y=1#z> the address of a site ends with its path: pages are found below it");
  EXPECT_EQ(site("https://a.org#z"),
            "<#z> the address of a site ends with its path: pages are found below it");
}

TEST(WebAddress, EditsEachFileAtItsOwn) {
  const std::string form = "https://git.example/me/course/_edit/main/{path}?return=1";
  EXPECT_EQ(edit(form), "");
  EXPECT_EQ(edit_address(form, "content/1-a/1.1-x.md"),
            "https://git.example/me/course/_edit/main/content/1-a/1.1-x.md?return=1");
  EXPECT_EQ(edit_address("https://a.org/{path}", "content/b c.md"),
            "https://a.org/content/b%20c.md");
  const std::string once = "`edit` has `{path}` in it once, for the lesson's file";
  EXPECT_EQ(edit("https://a.org/"), "<https://a.org/> " + once);
  EXPECT_EQ(edit("https://a.org/{path}{path}"), "<https://a.org/{path}{path}> " + once);
  EXPECT_EQ(edit("https://a.org/{path}/{branch}"), "<{> an address cannot have this character");
  EXPECT_EQ(edit("a.org/{path}"), "<a.org/{path}> `a.org/{path}` is not a web address");
}

TEST(WebAddress, EndsASitesRootWithASlash) {
  EXPECT_EQ(site_root("https://a.org/b"), "https://a.org/b/");
  EXPECT_EQ(site_root("https://a.org/b/"), "https://a.org/b/");
}

TEST(WebAddress, EscapesPaths) {
  EXPECT_EQ(escaped_path("1-a/1.1-x_y~.html"), "1-a/1.1-x_y~.html");
  EXPECT_EQ(escaped_path("a b&c/\xC3\xBC"), "a%20b%26c/%C3%BC");
}

TEST(WebAddress, EscapesWhatALinkLeadsTo) {
  EXPECT_EQ(escaped_address("https://a.org/b\\c d[0]?e=\"f\"&g=\xC3\xBC#h`"),
            "https://a.org/b%5Cc%20d%5B0%5D?e=%22f%22&g=%C3%BC#h%60");
  EXPECT_EQ(escaped_address("https://a.org/100%25~(x)'s;y"), "https://a.org/100%25~(x)'s;y");
  EXPECT_EQ(escaped_address("HTTP://[::1]:8000/a|b"), "HTTP://[::1]:8000/a%7Cb");
  EXPECT_EQ(escaped_address("http://a.`b`"), "http://a.%60b%60");
  EXPECT_EQ(escaped_address("mailto:a@b.org?subject=c d"), "mailto:a@b.org?subject=c%20d");
}

}  // namespace
}  // namespace mjcourse
