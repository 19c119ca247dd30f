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

// Empty where there is none.
std::string fault_of(const std::string& address, const std::string& token) {
  if (!is_printable(token)) return "MJCOURSE_STORE_TOKEN has a character that no token has";
  if (!is_printable(address)) return "it has a character that no address has";
  if (address.starts_with(kUnix)) {
    return address.starts_with("unix:/") ? "" : "its path must begin with /";
  }
  if (!address.starts_with("http://") && !address.starts_with("https://")) {
    return "it must begin with http://, https:// or unix:/";
  }
  if (address.find_first_of("?#") != address.npos) return "it is a folder's, and has no ? or #";
  return authority(address).empty() ? "it names no host" : "";
}

// What is wrong with the variables; empty where nothing is.
std::string read_keys(Server& server) {
  if (const std::string file = variable("MJCOURSE_STORE_SIGNING_KEY"); !file.empty()) {
    auto key = SigningKey::read(file);
    if (!key) return "MJCOURSE_STORE_SIGNING_KEY: " + key.error();
    server.signing_key = *std::move(key);
  }
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
  return "";
}

}  // namespace

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
  std::string fault = fault_of(address, server.token);
  if (fault.empty()) fault = read_keys(server);
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
