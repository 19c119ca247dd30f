#include "lsp/fence_suggestions.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <vector>

#include "lesson/blocks/fence_kinds.h"

namespace mjcourse {
namespace {

using Kind = Suggestion::Kind;
using Words = std::vector<std::string>;

Words words_of(const std::string& text) {
  std::istringstream stream(text);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool begins_with(const Words& words, const Words& start) {
  return words.size() >= start.size() && std::equal(start.begin(), start.end(), words.begin());
}

// The kind that an info string begins with, the one of most words; null where there is none.
const FenceKind* kind_of(const Words& info) {
  const FenceKind* found = nullptr;
  for (const FenceKind& kind : fence_kinds()) {
    const bool longer = found == nullptr || kind.words.size() > found->words.size();
    if (longer && begins_with(info, words_of(kind.words))) found = &kind;
  }
  return found;
}

std::string text_of(const FenceOption& option) {
  return std::string(option.name) + (option.has_value ? "=" : "");
}

}  // namespace

void add_fences(Suggestions& found) {
  for (const FenceKind& kind : fence_kinds()) {
    const bool needs = !kind.options.empty() && kind.options.front().needed;
    found.all.push_back({kind.words + (needs ? " " + text_of(kind.options.front()) : ""),
                         Kind::keyword, std::string(kind.meaning)});
  }
}

void add_options(Suggestions& found, const std::string& info) {
  const Words words = words_of(info);
  const FenceKind* own = kind_of(words);
  std::set<std::string> offered;
  for (const FenceKind& kind : fence_kinds()) {
    const Words longer = words_of(kind.words);
    if (longer.size() <= words.size() || !begins_with(longer, words)) continue;
    const std::string& next = longer[words.size()];
    if (offered.insert(next).second) {
      found.all.push_back({next, Kind::keyword, std::string(kind.meaning)});
    }
  }
  // Of a region that is shown nothing more is said.
  const bool is_region = own != nullptr && own->words == "cpp" && info.find('#') != info.npos;
  if (own == nullptr || is_region) return;
  for (const FenceOption& option : own->options) {
    const std::string text = text_of(option);
    const bool given = std::ranges::any_of(words, [&](const std::string& word) {
      return option.has_value ? word.starts_with(text) : word == text;
    });
    if (!given)
      found.all.push_back({text, Kind::property, own->words, std::string(option.meaning)});
  }
}

void add_choices(Suggestions& found, const std::string& info) {
  Words words = words_of(info);
  const FenceKind* own = kind_of(words);
  if (own == nullptr) return;
  for (const FenceOption& option : own->options) {
    if (option.name != words.back()) continue;
    for (const std::string_view value : option.values) {
      found.all.push_back(
          {std::string(value), Kind::value, own->words, std::string(option.meaning)});
    }
  }
}

}  // namespace mjcourse
