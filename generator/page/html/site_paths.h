// Where the pages and files of a site lie, each below its root, and what its own pages are called.
// Where a page leads to one of them it says its address.
#pragma once

#include <cstddef>
#include <string>

#include "course/course.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

// The file `path` as an address has it: "a b" is "a%20b". Needs no escape in HTML.
std::string site_address(const std::string& path);

// The way from the page or the file `path` to the site's root: "../" for each folder.
std::string way_to_root(const std::string& path);

// The lesson's page.
std::string page_path(const Lesson& lesson);
// A copy of a picture that the author put beside it.
std::string image_path(const Lesson& lesson, const Image& image, const ImageResult& result);
// The files of its block `index`, a lab, a figure or a plot, without the extension.
std::string block_path(const Lesson& lesson, std::size_t index);
// The zip that builds a program by itself; "" of one that did not run, or must not compile.
std::string program_zip_path(const Example& example, const ExampleResult* result);

// What a reader of the exercise begins with: a program, and the zip that builds it.
std::string exercise_path(const Exercise& exercise);
std::string exercise_zip_path(const Exercise& exercise);

// The pages that explain the course, and what stands beside them.
inline constexpr const char* kApiTitle = "MuJoCo’s names";
inline constexpr const char* kGalleryPage = "models.html";
inline constexpr const char* kGalleryTitle = "Models";
inline constexpr const char* kProgressPage = "progress.html";
inline constexpr const char* kProgressTitle = "Your progress";
inline constexpr const char* kReviewPage = "review.html";
inline constexpr const char* kReviewTitle = "Review";
inline constexpr const char* kKeptPage = "offline.html";
inline constexpr const char* kKeptTitle = "On this device";
inline constexpr const char* kPrintPage = "print.html";
inline constexpr const char* kSearchPage = "search.html";  // ?q=WORDS
inline constexpr const char* kSearchScript = "search.js";
inline constexpr const char* kVerificationPage = "verification.html";
inline constexpr const char* kVerificationJson = "verification.json";
inline constexpr const char* kFeed = "feed.xml";
inline constexpr const char* kOpenSearch = "opensearch.xml";

// Where the page or file `path` of the site is published; "" where the course has no address.
std::string web_address(const Course& course, const std::string& path);

}  // namespace mjcourse
