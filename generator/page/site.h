// Enter writing here: a course and its results become a site.
//
// Steps: each lesson's page and its pictures; the home page; what was verified. Then the pages that
// explain: the glossary, MuJoCo's names, models. Then the examples, to download; what other sites
// read; what leads on from former addresses; and the assets that the site's build made (styles,
// fonts, scripts). Last, what a browser needs to keep all this. All of it goes into a
// SiteDirectory, which replaces the old site at once.
// Tested by tests/generator/cli/build_test.cpp.
#pragma once

#include <cstddef>
#include <filesystem>

#include "course/course.h"
#include "course/last_changed.h"
#include "findings/evaluation.h"
#include "page/site_data.h"

namespace mjcourse {

// The file in a site of whose programs some have still to run as its pages run them.
inline constexpr const char* kProvisional = "assets/provisional.txt";

struct SitePaths {
  std::filesystem::path course;  // the course's folder
  std::filesystem::path assets;  // what site/bundle/build.mjs made; absolute
  // The generator's own file, which renders what a theme has; absolute.
  std::filesystem::path program;
  std::filesystem::path out;  // the site
  std::size_t threads = 1;    // on which the lessons are written
  bool compress = false;      // precompressed.h
  bool solutions = true;      // without_solutions.h
};

// `claims_of_outline` is asked for the claims of lessons of which an outline is kept, from any
// thread. `changes` is when the lessons' files were changed, as far as that is known. Throws
// std::runtime_error or std::system_error when the site cannot be written; the old one then stands
// as it was.
void write_site(const Course& course, const Evaluation& evaluation, const SitePaths& paths,
                const OutlineClaims& claims_of_outline, LastChanges changes);

}  // namespace mjcourse
