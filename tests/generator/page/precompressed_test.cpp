#include "page/precompressed.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

std::string files_of(const std::map<std::string, std::string>& site) {
  const TemporaryFolder folder;
  for (const auto& [path, bytes] : site) write_file(folder.path() / path, bytes);
  precompress(OutFolder(folder.path()), 2);
  std::string names;
  for (const std::string& name : DiskFiles(folder.path()).list("")) names += name + " ";
  return names;
}

TEST(Precompressed, StandsBesideWhatIsLoose) {
  const std::string text(1000, 'a');
  EXPECT_EQ(files_of({{"a.html", text}, {"b.webp", text}, {"c.zip", text}, {"d.woff2", text}}),
            "a.html a.html.br a.html.gz b.webp c.zip d.woff2 ");
}

TEST(Precompressed, IsLeftOutWhereItIsNotSmaller) {
  EXPECT_EQ(files_of({{"a.txt", ""}, {"b.txt", "ab"}}), "a.txt b.txt ");
}

TEST(Precompressed, SaysNoTime) {
  EXPECT_EQ(gzip("abc").substr(0, 10), std::string("\x1f\x8b\x08\0\0\0\0\0\x02\x03", 10));
}

}  // namespace
}  // namespace mjcourse
