#include "course/web_address.h"

#include <algorithm>
#include <charconv>

#include "base/percent_encoding.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr std::string_view kPath = "{path}";
constexpr const char* kForm = "write it whole: `https://example.org/course/`";

bool is_one_of(char c, std::string_view some) {
  return some.find(c) != some.npos;
}

// Where the host begins; 0 where `url` is not a web address.
std::size_t host_of(std::string_view url) {
  for (const std::string_view scheme : {"https://", "http://"}) {
    if (has_scheme(url, scheme)) return scheme.size();
  }
  return 0;
}

constexpr std::size_t kLastPort = 65535;

bool is_port(std::string_view text) {
  std::size_t port = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), port);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() && port > 0 &&
         port <= kLastPort;
}

// With its bytes where they are neither unreserved nor one of `more`.
std::string escaped(std::string_view text, std::string_view more) {
  return percent_encoded(text, [&](char c) { return is_unreserved(c) || is_one_of(c, more); });
}

// A name or a number, with a port behind it or without.
bool is_host(std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view name = text.substr(0, colon);
  const bool named =
      !name.empty() && name.front() != '.' && name.front() != '-' && name.find("..") == name.npos &&
      std::ranges::all_of(name, [](char c) { return is_letter_or_digit(c) || is_one_of(c, ".-"); });
  return named && (colon == text.size() || is_port(text.substr(colon + 1)));
}

// RFC 3986 names them; `[` and `]` may stand in a host alone.
constexpr std::string_view kReserved = "/:@!$&'()*+,;=?#%";

// What is escaped has two digits behind its `%`.
bool stands_in_address(std::string_view url, std::size_t at) {
  if (url[at] == '%') return encoded_byte(url, at).has_value();
  return is_unreserved(url[at]) || is_one_of(url[at], kReserved);
}

std::optional<AddressFault> address_fault(std::string_view url) {
  const std::size_t host = host_of(url);
  if (host == 0) {
    return AddressFault{0, url.size(), "`" + std::string(url) + "` is not a web address", kForm};
  }
  const std::size_t end = std::min(url.find_first_of("/?#", host), url.size());
  if (!is_host(url.substr(host, end - host))) {
    return AddressFault{host, std::max(end, host + 1), "the address names no host here",
                        "a host is `example.org` or `localhost:8000`; one with other letters than "
                        "English ones is written as `xn--…`"};
  }
  for (std::size_t i = end; i < url.size(); ++i) {
    if (stands_in_address(url, i)) continue;
    return AddressFault{i, i + 1, "an address cannot have this character",
                        "escape it with its bytes: a space is `%20`"};
  }
  return std::nullopt;
}

}  // namespace

bool has_scheme(std::string_view url, std::string_view scheme) {
  return url.size() >= scheme.size() &&
         std::equal(scheme.begin(), scheme.end(), url.begin(), [](char small, char any) {
           return small == (any >= 'A' && any <= 'Z' ? any - 'A' + 'a' : any);
         });
}

std::optional<AddressFault> site_address_fault(std::string_view url) {
  if (auto fault = address_fault(url)) return fault;
  const std::size_t more = url.find_first_of("?#");
  if (more == url.npos) return std::nullopt;
  return AddressFault{more, url.size(),
                      "the address of a site ends with its path: pages are found below it",
                      "leave out `" + std::string(url.substr(more)) + "`"};
}

std::optional<AddressFault> edit_address_fault(std::string_view edit) {
  const std::size_t at = edit.find(kPath);
  if (at == edit.npos || edit.find(kPath, at + 1) != edit.npos) {
    return AddressFault{0, edit.size(), "`edit` has `{path}` in it once, for the lesson's file",
                        "as in `https://github.com/me/course/edit/main/{path}`"};
  }
  // A file's path holds nothing that an address cannot have.
  const std::string before(edit.substr(0, at));
  auto fault = address_fault(before + "______" + std::string(edit.substr(at + kPath.size())));
  if (fault && host_of(edit) == 0) {
    fault->message = "`" + std::string(edit) + "` is not a web address";
    fault->cure = "as in `https://github.com/me/course/edit/main/{path}`";
  }
  return fault;
}

std::string site_root(const std::string& url) {
  return url.ends_with('/') ? url : url + "/";
}

std::string escaped_address(std::string_view address) {
  const std::size_t host = host_of(address);
  const std::size_t path =
      host == 0 ? 0 : std::min(address.find_first_of("/?#\\", host), address.size());
  return escaped(address.substr(0, path), std::string(kReserved) + "[]") +
         escaped(address.substr(path), kReserved);
}

std::string escaped_path(std::string_view path) {
  return escaped(path, "/");
}

std::string edit_address(const std::string& edit, const std::string& path) {
  std::string address = edit;
  return address.replace(address.find(kPath), kPath.size(), escaped_path(path));
}

}  // namespace mjcourse
