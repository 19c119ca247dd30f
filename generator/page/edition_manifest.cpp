#include "page/edition_manifest.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/content_hash.h"
#include "base/parallel.h"
#include "base/sha256.h"
#include "page/html/site_paths.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Against mistakes of a host and not against forgers.
constexpr std::size_t kHashDigits = 16;

bool is_shown(const std::string& path, const fs::path& site) {
  static const std::set<std::string> for_others{"sitemap.xml", "robots.txt", "feed.xml",
                                                "opensearch.xml"};
  const std::string name = fs::path(path).filename().string();
  if (name.starts_with('.') || for_others.contains(path)) return false;
  return !path.ends_with(".png") || !fs::exists((site / path).replace_extension(".webp"));
}

// In the order of their names.
std::vector<std::string> shown_files(const fs::path& site) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(site)) {
    const std::string path = entry.path().lexically_relative(site).generic_string();
    if (entry.is_regular_file() && is_shown(path, site)) paths.push_back(path);
  }
  std::ranges::sort(paths);
  return paths;
}

// What is so large that it is kept only where the reader asks for it: the compiler of C++.
std::set<std::string> large_assets(const json& assets) {
  std::set<std::string> large;
  for (const char* name : {"llvm.wasm.xz", "cpp.pack.xz"}) {
    if (assets.contains(name)) large.insert(assets.at(name).get<std::string>());
  }
  return large;
}

// Of the assets, what only labs, programs, single pages and former addresses need is left for
// later.
std::set<std::string> core_assets(const json& assets) {
  static const std::set<std::string> later{"lab.js",    "lab.css",      "engine.mjs", "engine.wasm",
                                           "review.js", "moved.js",     "program.js", "program.css",
                                           "cpp.js",    "llvm.wasm.xz", "cpp.pack.xz"};
  std::set<std::string> core;
  for (const auto& [name, path] : assets.items()) {
    if (!later.contains(name)) core.insert(path.get<std::string>());
  }
  return core;
}

// [hash, bytes]. Read piece by piece, since a page may be larger than all that a build has in mind.
json fingerprint_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  Sha256 hash;
  std::size_t bytes = 0;
  std::array<char, 1 << 14> piece;
  do {
    in.read(piece.data(), piece.size());
    const auto count = static_cast<std::size_t>(in.gcount());
    hash.add_raw({piece.data(), count});
    bytes += count;
  } while (in);
  return {hash.hex().substr(0, kHashDigits), bytes};
}

bool is_core(const std::string& path, const std::set<std::string>& assets, const Course& course) {
  static const std::set<std::string> pages{"index.html", kProgressPage, kKeptPage, kSearchPage,
                                           kSearchScript};
  return pages.contains(path) || assets.contains(path) || path.starts_with("search-") ||
         path.starts_with("assets/theme-") ||
         (course.glossary && path == page_path(course.glossary->page));
}

}  // namespace

json edition_manifest(const fs::path& site, const Course& course, const json& assets,
                      std::size_t threads) {
  const std::vector<std::string> paths = shown_files(site);
  std::vector<json> files(paths.size());
  for_each_index(paths.size(), threads, [&](std::size_t index, std::size_t) {
    files[index] = fingerprint_of(site / paths[index]);
  });
  const std::set<std::string> of_assets = core_assets(assets);
  const std::set<std::string> of_compiler = large_assets(assets);
  json manifest{{"core", json::array()}, {"asked", json::array()}, {"files", json::object()}};
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (is_core(paths[i], of_assets, course)) manifest["core"].push_back(paths[i]);
    if (of_compiler.contains(paths[i])) manifest["asked"].push_back(paths[i]);
    manifest["files"][paths[i]] = std::move(files[i]);
  }
  return manifest;
}

void write_edition(const OutFolder& site, const Course& course, const Files& assets,
                   std::size_t threads) {
  const json names = json::parse(assets.read("manifest.json").value());
  const std::string manifest = edition_manifest(site.path(), course, names, threads).dump() + "\n";
  const std::string path = "edition-" + content_hash(manifest) + ".json";
  site.write(path, manifest);
  site.write("sw.js", "self.mjcourseEdition=" + json(path).dump() + ";\n" +
                          assets.read("worker/sw.js").value());
}

}  // namespace mjcourse
