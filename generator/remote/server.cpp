#include "remote/server.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace mjcourse {
namespace {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool is_printable(std::string_view text) {
  return text.find_first_of(std::string_view("\0\t\n\v\f\r \"<>\\^`{|}", 16)) == text.npos;
}

// What stands before the path: "user:password@host:80".
std::string_view authority(std::string_view url) {
  const std::size_t begin = url.find("//") + 2;
  return url.substr(begin, url.find_first_of("/?#", begin) - begin);
}

constexpr std::string_view kUnix = "unix:";

// What is wrong with the variables; empty where nothing is.
std::string read_secrets(Server& server) {
  if (const std::string file = variable("MJCOURSE_STORE_SIGNING_KEY"); !file.empty()) {
    auto key = SigningKey::read(file);
    if (!key) return "MJCOURSE_STORE_SIGNING_KEY: " + key.error();
    server.signing_key = *std::move(key);
  }
  if (!is_printable(server.token)) {
    return "MJCOURSE_STORE_TOKEN has a character that no token has";
  }
  if (std::getenv("MJCOURSE_STORE_TRUSTED_KEYS") == nullptr) return "";
  const std::string keys = variable("MJCOURSE_STORE_TRUSTED_KEYS");
  constexpr const char* between = ", \t\n";
  for (std::size_t i = keys.find_first_not_of(between); i != keys.npos;) {
    const std::size_t end = std::min(keys.find_first_of(between, i), keys.size());
    server.trusted_keys.push_back(keys.substr(i, end - i));
    if (!is_public_key(server.trusted_keys.back())) {
      return "MJCOURSE_STORE_TRUSTED_KEYS has a word that is no public key, which has 64 "
             "hexadecimal digits";
    }
    i = keys.find_first_not_of(between, end);
  }
  // A CI sets a variable that it does not have to nothing, and that must not mean: trust all.
  if (server.trusted_keys.empty()) {
    return "MJCOURSE_STORE_TRUSTED_KEYS lists no key; unset it to trust everybody";
  }
  return "";
}

}  // namespace

std::string store_address_fault(const std::string& address) {
  const std::string begin = "the address of a shared store ";
  if (!is_printable(address)) return begin + "has no blanks, quotes or brackets";
  if (address.starts_with(kUnix)) {
    return address.starts_with("unix:/") ? "" : begin + "has a / behind unix:";
  }
  if (!address.starts_with("http://") && !address.starts_with("https://")) {
    return begin + "begins with http://, https:// or unix:/";
  }
  if (address.find_first_of("?#") != address.npos) return begin + "is a folder's, without ? and #";
  return authority(address).empty() ? begin + "names a host" : "";
}

std::string Server::shown() const {
  if (!socket.empty()) return "unix:" + socket;
  const std::string_view all = authority(url);
  const std::size_t user = all.rfind('@');
  if (user == all.npos) return url;
  std::string text = url;
  return text.erase(text.find("//") + 2, user + 1);
}

tl::expected<Server, std::string> server_at(const std::string& address) {
  Server server;
  server.token = variable("MJCOURSE_STORE_TOKEN");
  server.certificate = variable("MJCOURSE_STORE_CERTIFICATE");
  server.key = variable("MJCOURSE_STORE_KEY");
  server.authorities = variable("MJCOURSE_STORE_AUTHORITIES");
  std::string fault = store_address_fault(address);
  if (fault.empty()) fault = read_secrets(server);
  if (!fault.empty()) return tl::unexpected(std::move(fault));
  if (address.starts_with(kUnix)) {
    server.socket = address.substr(kUnix.size());
    server.url = "http://localhost";
    return server;
  }
  server.url = address;
  while (server.url.ends_with('/')) server.url.pop_back();
  return server;
}

}  // namespace mjcourse
