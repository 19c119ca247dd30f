#include "lsp/file_uri.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(FileUri, NamesAPath) {
  EXPECT_EQ(uri_of("/a b/ö%.md"), "file:///a%20b/%C3%B6%25.md");
  EXPECT_EQ(path_of("file:///a%20b/%c3%b6%25.md"), "/a b/ö%.md");
  EXPECT_EQ(path_of("file://localhost/a/./b/../c"), "/a/c");
}

TEST(FileUri, OfNoFileHasNoPath) {
  for (const char* uri : {"untitled:Untitled-1", "file:relative", "file://host/share", "file:///%",
                          "file:///%4", "file:///%zz", "file:///%00", ""}) {
    EXPECT_EQ(path_of(uri), std::nullopt) << uri;
  }
}

}  // namespace
}  // namespace mjcourse
