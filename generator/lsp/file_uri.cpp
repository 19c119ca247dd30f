#include "lsp/file_uri.h"

#include "base/percent_encoding.h"

namespace mjcourse {
namespace {

constexpr std::string_view kScheme = "file://";

}  // namespace

std::string uri_of(const std::filesystem::path& path) {
  return std::string(kScheme) +
         percent_encoded(path.string(), [](char c) { return is_unreserved(c) || c == '/'; });
}

std::optional<std::filesystem::path> path_of(std::string_view uri) {
  if (!uri.starts_with(kScheme)) return std::nullopt;
  uri.remove_prefix(kScheme.size());
  if (uri.starts_with("localhost/")) uri.remove_prefix(std::string_view("localhost").size());
  if (!uri.starts_with('/')) return std::nullopt;
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      path += uri[i];
      continue;
    }
    const std::optional<char> byte = encoded_byte(uri, i);
    if (!byte || *byte == '\0') return std::nullopt;
    path += *byte;
    i += kEncodedByte - 1;
  }
  return std::filesystem::path(path).lexically_normal();
}

}  // namespace mjcourse
