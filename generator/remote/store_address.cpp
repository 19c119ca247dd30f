#include "remote/store_address.h"

#include <algorithm>
#include <charconv>

#include "base/percent_encoding.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr std::string_view kUnix = "unix:";
constexpr int kLastPort = 65535;
constexpr std::uint16_t kHttpPort = 80, kHttpsPort = 443;

// What ends a name or a password for one reader, and not for another.
constexpr const char* kOtherAt =
    "has no @ but the one that ends its name and password: write any other as %40, and in these "
    "two / as %2F, ? as %3F and # as %23, or put them into ~/.netrc, or a token into "
    "MJCOURSE_STORE_TOKEN";

bool is_control(char c) {
  return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}

bool is_printable(std::string_view text) {
  return text.find_first_of(" \"<>\\^`{|}") == text.npos && std::ranges::none_of(text, is_control);
}

// Does each percent sign begin a byte, and is that one of a name's or a password's?
bool is_encoded(std::string_view text) {
  for (std::size_t at = 0; (at = text.find('%', at)) != text.npos; ++at) {
    const auto byte = encoded_byte(text, at);
    if (!byte || is_control(*byte)) return false;
  }
  return true;
}

bool is_of_a_name(char c) {
  return is_unreserved(c) || static_cast<unsigned char>(c) >= 0x80;
}

bool is_of_a_number(char c) {
  return is_letter_or_digit(c) || std::string_view(":.%").find(c) != std::string_view::npos;
}

// A name, or the number of IPv6 in brackets.
bool is_host(std::string_view host) {
  if (!host.starts_with('[')) return std::ranges::all_of(host, is_of_a_name);
  return host.size() > 2 && host.ends_with(']') &&
         std::ranges::all_of(host.substr(1, host.size() - 2), is_of_a_number);
}

bool is_port(std::string_view digits) {
  int port = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  return error == std::errc() && end == digits.data() + digits.size() && port > 0 &&
         port <= kLastPort;
}

// Where the host ends in "host:80", "[::1]:80".
std::size_t end_of_host(std::string_view place) {
  const std::size_t begin = place.starts_with('[') ? std::min(place.find(']'), place.size()) : 0;
  return std::min(place.find(':', begin), place.size());
}

// "host:80" in "https://host:80/x".
std::string_view place_in(std::string_view url) {
  const std::string_view rest = url.substr(url.find("//") + 2);
  return rest.substr(0, rest.find('/'));
}

// What is wrong with "host:80"; empty where nothing is.
std::string place_fault(std::string_view place) {
  const std::string_view host = place.substr(0, end_of_host(place));
  if (host.empty()) return "names a host";
  if (!is_host(host)) return "has a character in its host that no name of one has";
  if (host.size() < place.size() && !is_port(place.substr(host.size() + 1))) {
    return "has a number from 1 to 65535 behind the colon of its host";
  }
  return "";
}

// "name:password" in front of the @; gives what stands behind it.
std::string_view take_userinfo(std::string_view authority, StoreAddress& address) {
  const std::size_t end = authority.find('@');
  if (end == authority.npos) return authority;
  const std::string_view all = authority.substr(0, end);
  const std::size_t colon = std::min(all.find(':'), all.size());
  address.user = all.substr(0, colon);
  address.password = all.substr(std::min(colon + 1, all.size()));
  return authority.substr(end + 1);
}

// Of the address behind "https://", into what was read of it; what is wrong with it.
std::string read_place(std::string_view rest, StoreAddress& address) {
  const std::size_t end = std::min(rest.find_first_of("/?#"), rest.size());
  std::string_view path = rest.substr(end);
  const std::string_view place = take_userinfo(rest.substr(0, end), address);
  if (place.find('@') != place.npos || path.find('@') != path.npos) return kOtherAt;
  if (path.find_first_of("?#") != path.npos) return "is a folder's, without ? and #";
  if (!is_encoded(address.user) || !is_encoded(address.password)) {
    return "has %25 for a % in its name or password";
  }
  while (path.ends_with('/')) path.remove_suffix(1);
  address.url.append(place).append(path);
  return place_fault(place);
}

// Into an address without anything; what is wrong with it.
std::string read(std::string_view text, StoreAddress& address) {
  if (!is_printable(text)) return "has no blanks, quotes or brackets";
  if (text.starts_with(kUnix)) {
    address.socket = text.substr(kUnix.size());
    address.url = "http://localhost";
    return address.socket.starts_with('/') ? "" : "has a / behind unix:";
  }
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (!text.starts_with(scheme)) continue;
    address.url = scheme;
    return read_place(text.substr(scheme.size()), address);
  }
  return "begins with http://, https:// or unix:/";
}

}  // namespace

tl::expected<StoreAddress, std::string> read_store_address(std::string_view text) {
  StoreAddress address;
  const std::string fault = read(text, address);
  if (!fault.empty()) return tl::unexpected("the address of a shared store " + fault);
  return address;
}

std::string StoreAddress::shown() const {
  return socket.empty() ? url : "unix:" + socket;
}

std::string StoreAddress::host() const {
  std::string_view host = place_in(url);
  host = host.substr(0, end_of_host(host));
  if (host.starts_with('[')) host = host.substr(1, host.size() - 2);
  return std::string(host);
}

std::uint16_t StoreAddress::port() const {
  const std::string_view place = place_in(url);
  const std::size_t end = end_of_host(place);
  if (end == place.size()) return url.starts_with("https:") ? kHttpsPort : kHttpPort;
  std::uint16_t port = 0;
  std::from_chars(place.data() + end + 1, place.data() + place.size(), port);
  return port;
}

std::string without_userinfo(std::string text) {
  constexpr std::string_view behind_scheme = "://";
  const std::size_t scheme = text.find(behind_scheme);
  const std::size_t at = text.rfind('@');
  if (scheme == text.npos || at == text.npos || at < scheme) return text;
  const std::size_t begin = scheme + behind_scheme.size();
  return text.replace(begin, at - begin, "…");
}

}  // namespace mjcourse
