// The addresses in course.yaml, where the site is published and where a lesson is edited, and those
// of links.
//
// An address of course.yaml goes into pages, the sitemap and the feed as it stands, so it must be
// one to the letter: absolute, of the web, and with whatever is no plain character escaped. For a
// library's grammar (liburiparser), `example.org` and `https://:80/` are addresses too.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

// What is wrong with an address, and where in it.
struct AddressFault {
  std::size_t begin, end;
  std::string message, cure;
};

// Of the address of a site: a page's path is put behind it, so it has no query and no fragment.
std::optional<AddressFault> site_address_fault(std::string_view url);
// Of the address of an editor, in which {path} stands for a lesson's file below the course.
std::optional<AddressFault> edit_address_fault(std::string_view edit);

// Does `url` begin with `scheme`, "https://", whatever the case of its letters?
bool has_scheme(std::string_view url, std::string_view scheme);

// The site's root, which ends with a slash.
std::string site_root(const std::string& url);
// What a link leads to, `address`, as a page has it: all that is no character of an address is
// escaped, since browsers take `\` for `/`.
std::string escaped_address(std::string_view address);
// `path` as an address has it: "a b" is "a%20b".
std::string escaped_path(std::string_view path);
// Where the file `path` of the course is edited.
std::string edit_address(const std::string& edit, const std::string& path);

}  // namespace mjcourse
