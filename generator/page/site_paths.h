// Where a lesson's files lie on the site, each below its root. Where a page leads to one of them,
// or to any other file of the site, it says its address.
#pragma once

#include <cstddef>
#include <string>

#include "findings/result.h"
#include "lesson/lesson.h"

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

}  // namespace mjcourse
