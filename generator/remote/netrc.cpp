#include "remote/netrc.h"

#include <strings.h>

#include <algorithm>

namespace mjcourse {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

// The words of the file, one after the other.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  // Nothing at the end, and where a quote has none.
  std::optional<std::string> next() {
    for (;;) {
      rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
      if (!rest_.starts_with('#')) break;
      skip_to("\n");
    }
    if (rest_.empty()) return std::nullopt;
    return rest_.starts_with('"') ? quoted() : plain();
  }

  // The commands of a macro, which end with an empty line.
  void skip_macro() { skip_to("\n\n"); }

 private:
  void skip_to(std::string_view end) {
    const std::size_t at = rest_.find(end);
    rest_.remove_prefix(at == rest_.npos ? rest_.size() : at + end.size());
  }

  std::optional<std::string> plain() {
    const std::size_t end = std::min(rest_.find_first_of(kBlanks), rest_.size());
    std::string word(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return word;
  }

  std::optional<std::string> quoted() {
    std::string word;
    std::size_t i = 1;
    for (; i < rest_.size() && rest_[i] != '"'; ++i) {
      word += rest_[i] == '\\' && i + 1 < rest_.size() ? meant(rest_[++i]) : rest_[i];
    }
    const bool has_end = i < rest_.size();
    rest_.remove_prefix(std::min(i + 1, rest_.size()));
    return has_end ? std::optional(word) : std::nullopt;
  }

  static char meant(char escaped) {
    switch (escaped) {
      case 'n':
        return '\n';
      case 'r':
        return '\r';
      case 't':
        return '\t';
      default:
        return escaped;
    }
  }

  std::string_view rest_;
};

bool is_same_host(const std::string& one, std::string_view other) {
  return one.size() == other.size() && strncasecmp(one.data(), other.data(), one.size()) == 0;
}

}  // namespace

std::optional<Login> login_in(std::string_view netrc, std::string_view host,
                              std::string_view user) {
  Words words(netrc);
  bool is_ours = false;
  std::optional<std::string> name, password;
  while (const auto word = words.next()) {
    if (word == "machine" || word == "default") {
      is_ours = word == "default" || is_same_host(words.next().value_or(""), host);
      name = password = std::nullopt;
    } else if (word == "macdef") {
      words.skip_macro();
    } else if (word == "login") {
      name = words.next();
    } else if (word == "password") {
      password = words.next();
    } else if (word == "account") {
      words.next();
    }
    const bool is_whole = is_ours && name && password;
    if (is_whole && (user.empty() || *name == user)) return Login{*name, *password};
  }
  return std::nullopt;
}

}  // namespace mjcourse
