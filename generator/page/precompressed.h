// The files of a site as a server would send them. Beside each whose format is not compressed
// already lie NAME.br and NAME.gz, where these are smaller. nginx (`brotli_static`, `gzip_static`),
// Caddy (`precompressed`) and others give those to browsers that take them. They are packed better
// than a server has time for.
//
// The same bytes give the same bytes: the heads of .gz say no time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/out_folder.h"

namespace mjcourse {

// As tightly as they can. Throw std::runtime_error where there is no memory.
std::string brotli(std::string_view bytes);
std::string gzip(std::string_view bytes);

// On so many threads.
void precompress(const OutFolder& site, std::size_t threads);

}  // namespace mjcourse
