#include "page/edition_manifest.h"

#include <gtest/gtest.h>

#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

using nlohmann::json;

class EditionManifest : public testing::Test {
 protected:
  void write(const std::string& path, const std::string& bytes) {
    write_file(folder_.path() / path, bytes);
  }
  json manifest(std::size_t threads = 1) const {
    return edition_manifest(folder_.path(), course_,
                            {{"site.css", "assets/site-1.css"},
                             {"lab.js", "assets/lab-1.js"},
                             {"llvm.wasm.xz", "assets/llvm-1.wasm.xz"}},
                            threads);
  }

  const TemporaryFolder folder_;
  Course course_;
};

TEST_F(EditionManifest, HasHashAndSizeOfEachFile) {
  write("1-a/1.1-b.html", "abc");
  EXPECT_EQ(manifest(),
            (json{{"core", json::array()},
                  {"asked", json::array()},
                  {"files", {{"1-a/1.1-b.html", json::array({"ba7816bf8f01cfea", 3})}}}}));
}

TEST_F(EditionManifest, LeavesOutWhatNoPageShows) {
  for (const char* path : {".mjcourse-site", "sitemap.xml", "robots.txt", "feed.xml",
                           "opensearch.xml", "p.png", "p.webp", "alone.png", "models/feed.xml"}) {
    write(path, "");
  }
  const json all = manifest();
  std::string names;
  for (const auto& [path, file] : all["files"].items()) names += path + " ";
  EXPECT_EQ(names, "alone.png models/feed.xml p.webp ");
}

TEST_F(EditionManifest, HasInItsCoreWhatEveryReaderNeeds) {
  for (const char* path : {"assets/lab-1.js", "assets/site-1.css", "assets/theme-1.css",
                           "assets/font.woff2", "index.html", "offline.html", "1-a/1.1-b.html",
                           "search.js", "search-1.js", "search.html", "404.html"}) {
    write(path, "");
  }
  EXPECT_EQ(manifest()["core"], json({"assets/site-1.css", "assets/theme-1.css", "index.html",
                                      "offline.html", "search-1.js", "search.html", "search.js"}));
}

TEST_F(EditionManifest, LeavesToItsReadersWhatIsLarge) {
  for (const char* path : {"assets/llvm-1.wasm.xz", "assets/lab-1.js"}) write(path, "");
  EXPECT_EQ(manifest()["asked"], json({"assets/llvm-1.wasm.xz"}));
  EXPECT_EQ(manifest()["core"], json::array());
}

TEST_F(EditionManifest, DoesNotDependOnThreads) {
  for (int i = 0; i < 50; ++i) write(std::to_string(i) + ".html", std::to_string(i));
  EXPECT_EQ(manifest().dump(), manifest(4).dump());
}

TEST_F(EditionManifest, MakesAnotherWorkerOfAnotherSite) {
  const MemoryFiles assets{{{"manifest.json", "{}"}, {"worker/sw.js", "work();\n"}}};
  const auto worker = [&] {
    write_edition(OutFolder(folder_.path()), course_, assets, 1);
    std::string text = DiskFiles(folder_.path()).read("sw.js").value();
    for (const std::string& name : DiskFiles(folder_.path()).list("")) {
      if (name.starts_with("edition-") || name == "sw.js")
        std::filesystem::remove(folder_.path() / name);
    }
    return text;
  };
  write("a.html", "a");
  const std::string first = worker();
  EXPECT_EQ(first, worker());
  EXPECT_TRUE(first.ends_with(".json\";\nwork();\n")) << first;
  write("a.html", "b");
  EXPECT_NE(first, worker());
}

}  // namespace
}  // namespace mjcourse
