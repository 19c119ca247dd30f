#include "page/html/html_tag.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// Each opening tag as "name[a=b][c=]".
std::string tags_in(const std::string& html) {
  std::string all;
  with_tags(html, [&](const HtmlTag& tag) {
    all += std::string(tag.name);
    for (const HtmlAttribute& one : tag.attributes) {
      all += "[" + std::string(one.name) + "=" + std::string(one.value) + "]";
    }
    all += std::string(tag.close) + " ";
    return std::string(tag.text);
  });
  return all;
}

TEST(HtmlTag, HasItsAttributes) {
  EXPECT_EQ(tags_in(R"(<a href="x.html" title='a "b" > c' data-n=3 hidden>t</a>)"),
            R"(a[href=x.html][title=a "b" > c][data-n=3][hidden=]> )");
  EXPECT_EQ(tags_in("<br/><img\n  src=\"a.png\"\talt=\"\" />"), "br/> img[src=a.png][alt=]/> ");
}

TEST(HtmlTag, IsNoOtherMark) {
  EXPECT_EQ(tags_in("1 < 2, </p>, <!-- c -->, <!doctype html>, <3 <"), "");
}

TEST(HtmlTag, IsReadAsBrowsersReadIt) {
  EXPECT_EQ(tags_in("<a / b = c>"), "a[b=][c=]> ");
  EXPECT_EQ(tags_in("<a b=c/d>"), "a[b=c/d]> ");
  EXPECT_EQ(tags_in("<p><b>"), "p> b> ");
}

TEST(HtmlTag, MayNotBeWhole) {
  for (const std::string html : {"<a", "<a ", "<a b", "<a b=", "<a b=\"c", "<a b=\"c\"", "<a /"}) {
    EXPECT_EQ(with_tags(html, [](const HtmlTag& tag) { return std::string(tag.text); }), html);
  }
}

TEST(HtmlTag, GivesTheValueOfItsFirstAttributeOfAName) {
  with_tags("<a id=x id=y class>", [](const HtmlTag& tag) {
    EXPECT_EQ(tag.value_of("id"), "x");
    EXPECT_EQ(tag.value_of("class"), "");
    EXPECT_EQ(tag.value_of("href"), "");
    return std::string();
  });
}

TEST(HtmlTag, IsChangedAloneAndTheRestStaysToTheByte) {
  const std::string html = "a &amp; <b  class = x>b</b >\r\n<i>c</i><";
  const auto change = [](const HtmlTag& tag) {
    return tag.name == "i" ? std::string("<em>") : std::string(tag.text);
  };
  EXPECT_EQ(with_tags(html, change), "a &amp; <b  class = x>b</b >\r\n<em>c</i><");
}

}  // namespace
}  // namespace mjcourse
