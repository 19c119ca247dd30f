#include "lsp/file_uri.h"

#include <cctype>
#include <charconv>

namespace mjcourse {
namespace {

constexpr std::string_view kScheme = "file://";

bool stays(unsigned char c) {
  return std::isalnum(c) != 0 ||
         std::string_view("/-._~").find(static_cast<char>(c)) != std::string_view::npos;
}

}  // namespace

std::string uri_of(const std::filesystem::path& path) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri(kScheme);
  for (const char c : path.string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (stays(byte)) {
      uri += c;
    } else {
      uri += {'%', digits[byte >> 4U], digits[byte & 15U]};
    }
  }
  return uri;
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
    unsigned char byte = 0;
    const std::string_view digits = uri.substr(i + 1, 2);
    const auto read = std::from_chars(digits.begin(), digits.end(), byte, 16);
    if (digits.size() != 2 || read.ptr != digits.end() || byte == 0) return std::nullopt;
    path += static_cast<char>(byte);
    i += 2;
  }
  return std::filesystem::path(path).lexically_normal();
}

}  // namespace mjcourse
