// What lets a browser keep a site and read it without a network: two files at its root.
//
//   edition-HASH.json   the site as this build made it: of each file a hash and its size, and which
//                       of them every reader needs first. Its shape is
//                       site/browser/worker/edition.ts.
//   sw.js               the service worker, with the former's name in front. So it is another one
//                       whenever anything in the site is, and the browser sees a newer version
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/out_folder.h"
#include "course/course.h"

namespace mjcourse {

// What is in `site`, on so many threads. Left out is what no page shows: files that begin with a
// dot, what is for search engines and feed readers, and the PNG of a picture that is a WebP as
// well.
nlohmann::json edition_manifest(const std::filesystem::path& site, const Course& course,
                                const nlohmann::json& assets, std::size_t threads);

// Both files, into `site`, which has all others. `assets` is what the site's build made.
void write_edition(const OutFolder& site, const Course& course, const Files& assets,
                   std::size_t threads);

}  // namespace mjcourse
