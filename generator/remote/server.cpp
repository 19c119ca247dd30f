#include "remote/server.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "base/files.h"
#include "base/percent_encoding.h"
#include "remote/netrc.h"

namespace mjcourse {
namespace {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// What is in the file that a variable names; empty where it names none. A CI's user may have put
// there what the file is to hold, so a fault does not repeat it.
tl::expected<std::string, std::string> file_in(const char* name) {
  const std::string file = variable(name);
  if (file.empty()) return "";
  // Nothing would stand for: not set.
  if (const auto text = read_file(file); text && !text->empty()) return *text;
  return tl::unexpected(std::string(name) + " does not name a file that can be read");
}

// What a header may hold of a token.
bool is_token(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c > ' ' && c < '\x7f'; });
}

// Each variable that names a file, and where what that holds is kept.
std::string read_files(Server& server) {
  for (const auto& [name, file] : {std::pair("MJCOURSE_STORE_CERTIFICATE", &server.certificate),
                                   std::pair("MJCOURSE_STORE_KEY", &server.key),
                                   std::pair("MJCOURSE_STORE_AUTHORITIES", &server.authorities)}) {
    auto read = file_in(name);
    if (!read) return read.error();
    *file = *std::move(read);
  }
  // As for curl; it is other programs' too, so what is wrong with it is theirs to say.
  if (server.authorities.empty()) server.authorities = file_in("SSL_CERT_FILE").value_or("");
  return "";
}

std::string read_signing_key(Server& server) {
  constexpr const char* name = "MJCOURSE_STORE_SIGNING_KEY";
  if (variable(name).empty()) return "";
  if (const auto text = file_in(name); !text) return text.error();
  auto key = SigningKey::read(variable(name));
  if (!key) return std::string(name) + ": " + key.error();
  server.signing_key = *std::move(key);
  return "";
}

// What is wrong with the variables; empty where nothing is.
std::string read_secrets(Server& server) {
  server.token = variable("MJCOURSE_STORE_TOKEN");
  if (!is_token(server.token)) return "MJCOURSE_STORE_TOKEN has a character that no token has";
  return read_files(server);
}

// Likewise.
std::string read_keys(Server& server) {
  if (std::string fault = read_signing_key(server); !fault.empty()) return fault;
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

// As libcurl does: a name in the address chooses among those of a host, and a password stays.
void read_netrc(Server& server) {
  StoreAddress& address = server.address;
  const std::string home = variable("HOME");
  const bool is_known = !server.token.empty() || !address.password.empty();
  if (is_known || home.empty() || !address.socket.empty()) return;
  const auto text = read_file(home + "/.netrc");
  const auto login = text ? login_in(*text, address.host(), address.user) : std::nullopt;
  if (!login) return;
  address.user = percent_encoded(login->user, is_unreserved);
  address.password = percent_encoded(login->password, is_unreserved);
}

}  // namespace

tl::expected<Server, std::string> server_at(const std::string& address) {
  auto read = read_store_address(address);
  if (!read) return tl::unexpected(std::move(read.error()));
  Server server;
  server.address = *std::move(read);
  std::string fault = read_keys(server);
  if (fault.empty()) fault = read_secrets(server);
  if (!fault.empty()) return tl::unexpected(std::move(fault));
  read_netrc(server);
  return server;
}

tl::expected<Server, std::string> no_server() {
  Server server;
  std::string fault = read_keys(server);
  if (!fault.empty()) return tl::unexpected(std::move(fault));
  return server;
}

Trust Server::trust() const {
  Trust trust{.everybody = false, .keys = {trusted_keys.begin(), trusted_keys.end()}};
  if (signing_key) trust.keys.insert(signing_key->public_key());
  trust.everybody = trust.keys.empty();
  return trust;
}

}  // namespace mjcourse
