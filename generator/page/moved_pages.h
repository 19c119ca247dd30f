// The pages at the former addresses of lessons, which lead to where these are now.
//
// A site of files cannot answer with a redirect, so each is a small page that sends its reader on.
// It does so by a script, which keeps the heading that was linked to; without scripts, by a
// refresh; and in words.
// Tested by tests/generator/page/web_files_test.cpp.
#pragma once

#include "page/html/site_files.h"
#include "page/site_data.h"
#include "script/templates.h"

namespace mjcourse {

void write_moved_pages(const SiteData& site, Templates& templates, SiteFiles& directory);

}  // namespace mjcourse
