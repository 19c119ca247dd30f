#include "remote/net_command.h"

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "process/open_to_all.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// A limit of the kernel's for when nobody is left to look: of the time of processors, which a
// preview of many days does not take.
constexpr double kLifetime = 24 * 3600;
constexpr std::uint64_t kOpenFiles = 256;  // for each connection, and each name that is looked up
constexpr std::uint16_t kNames = 53;
// Where an address of a proxy has none, for http and for https.
constexpr std::uint16_t kProxies[] = {1080, 443};

constexpr const char* kProxyVariables[] = {"http_proxy", "https_proxy", "HTTPS_PROXY", "all_proxy",
                                           "ALL_PROXY"};
// Beside those: what else libcurl and the C library's resolver heed.
constexpr const char* kOtherVariables[] = {"no_proxy", "NO_PROXY", "LOCALDOMAIN", "RES_OPTIONS"};

// Which servers know names, and whom to trust. No keys: those are in /etc/ssl/private.
constexpr const char* kSettings[] = {"/etc/resolv.conf",      "/etc/hosts",
                                     "/etc/nsswitch.conf",    "/etc/host.conf",
                                     "/etc/gai.conf",         "/etc/ssl/certs",
                                     "/etc/ssl/cert.pem",     "/etc/ssl/openssl.cnf",
                                     "/etc/pki/ca-trust",     "/etc/pki/tls/certs",
                                     "/etc/pki/tls/cert.pem", "/etc/pki/tls/openssl.cnf",
                                     "/etc/ca-certificates",  "/etc/crypto-policies"};

// The list of name servers is replaced when a machine comes to another network. Where others write
// it, it lies in a folder of theirs below /run.
std::string folder_of_name_servers() {
  std::error_code none;
  const fs::path list = fs::canonical("/etc/resolv.conf", none);
  const fs::path folder = list.parent_path();
  return none || folder.parent_path() == "/" ? "" : folder.string();
}

// "80" in "http://ann:secret@proxy:80/"; what is no number is for libcurl to refuse.
std::optional<std::uint16_t> port_in(std::string_view proxy) {
  if (const std::size_t scheme = proxy.find("://"); scheme != proxy.npos) {
    proxy.remove_prefix(scheme + 3);
  }
  proxy = proxy.substr(0, proxy.find_first_of("/?#"));
  const std::size_t colon = proxy.rfind(':');
  if (colon == proxy.npos) return std::nullopt;
  std::uint16_t port = 0;
  const char* const end = proxy.data() + proxy.size();
  const auto read = std::from_chars(proxy.data() + colon + 1, end, port);
  return read.ec == std::errc() && read.ptr == end ? std::optional(port) : std::nullopt;
}

void add_variable(const char* name, Command& command) {
  const char* const value = std::getenv(name);
  if (value != nullptr) command.environment.push_back(std::string(name) + "=" + value);
}

void allow_network(const StoreAddress& address, Command& command) {
  Sandbox& sandbox = *command.sandbox;
  sandbox.network = true;
  sandbox.ports = {address.port(), kNames};
  for (const char* name : kProxyVariables) {
    const char* const proxy = std::getenv(name);
    if (proxy == nullptr || *proxy == '\0') continue;
    add_variable(name, command);
    if (const auto port = port_in(proxy)) {
      sandbox.ports.push_back(*port);
    } else {
      sandbox.ports.insert(sandbox.ports.end(), std::begin(kProxies), std::end(kProxies));
    }
  }
  for (const char* name : kOtherVariables) add_variable(name, command);
  sandbox.read.insert(sandbox.read.end(), std::begin(kSettings), std::end(kSettings));
  if (const std::string folder = folder_of_name_servers(); !folder.empty()) {
    sandbox.read.push_back(folder);
  }
}

}  // namespace

Command net_command(const fs::path& program, const StoreAddress& address) {
  Command command;
  command.arguments = {program.string()};
  command.folder = "/";
  command.seconds = kLifetime;
  command.answers = true;
  Sandbox sandbox;
  sandbox.read = {program.string()};
  sandbox.reads_all = !can_be_read_by_all(program);
  sandbox.file_bytes = 0;
  sandbox.open_files = kOpenFiles;
  sandbox.narrows = true;
#ifdef __SANITIZE_ADDRESS__
  sandbox.reserves = true;
#endif
  command.sandbox = std::move(sandbox);
  if (address.socket.empty()) allow_network(address, command);
  return command;
}

}  // namespace mjcourse
