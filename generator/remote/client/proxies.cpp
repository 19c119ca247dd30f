#include "remote/client/proxies.h"

#include <curl/curl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

namespace mjcourse {
namespace {

constexpr std::array<std::string_view, 7> kSchemes{"http",    "https",  "socks",  "socks4",
                                                   "socks4a", "socks5", "socks5h"};

// As libcurl looks for them: HTTP_PROXY may be a header of somebody's request.
std::vector<const char*> variables_for(const std::string& url) {
  if (url.starts_with("http://")) return {"http_proxy", "all_proxy", "ALL_PROXY"};
  return {"https_proxy", "HTTPS_PROXY", "all_proxy", "ALL_PROXY"};
}

std::string part_of(CURLU* address, CURLUPart part) {
  char* text = nullptr;
  if (curl_url_get(address, part, &text, 0) != CURLUE_OK) return "";
  std::string copy = text;
  curl_free(text);
  return copy;
}

// Does libcurl find a host in it, and no part of a password behind that?
bool is_address(const char* proxy) {
  const std::unique_ptr<CURLU, decltype(&curl_url_cleanup)> address(curl_url(), curl_url_cleanup);
  constexpr unsigned flags = CURLU_NON_SUPPORT_SCHEME | CURLU_GUESS_SCHEME;
  if (curl_url_set(address.get(), CURLUPART_URL, proxy, flags) != CURLUE_OK) return false;
  const std::string host = part_of(address.get(), CURLUPART_HOST);
  std::string behind;
  for (const auto part : {CURLUPART_PATH, CURLUPART_QUERY, CURLUPART_FRAGMENT}) {
    behind += part_of(address.get(), part);
  }
  return std::ranges::count(kSchemes, part_of(address.get(), CURLUPART_SCHEME)) > 0 &&
         (host + behind).find('@') == std::string::npos;
}

}  // namespace

std::string proxy_fault(const std::string& url) {
  for (const char* name : variables_for(url)) {
    const char* const proxy = std::getenv(name);
    if (proxy == nullptr || *proxy == '\0') continue;
    if (is_address(proxy)) return "";
    return std::string(name) +
           " does not hold the address of a proxy: in a name or password, write / as %2F, ? as "
           "%3F, # as %23 and @ as %40";
  }
  return "";
}

}  // namespace mjcourse
