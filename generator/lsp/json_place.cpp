#include "lsp/json_place.h"

#include <algorithm>
#include <ranges>
#include <utility>

namespace mjcourse {
namespace {

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  JsonPlace run() {
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '"') {
        string();
      } else if (c == '{') {
        place_.objects.emplace_back().lists = lists();
        lists_.push_back(false);
      } else if (c == '[') {
        lists_.push_back(true);
      } else if (c == '}' || c == ']') {
        close(c == ']');
      } else if (c == ',' && !in_list() && !place_.objects.empty()) {
        place_.objects.back().key.clear();
      }
    }
    place_.lists = lists();
    return place_;
  }

 private:
  bool in_list() const { return !lists_.empty() && lists_.back(); }

  // Within the innermost object.
  int lists() const {
    const auto object = std::find(lists_.rbegin(), lists_.rend(), false);
    return static_cast<int>(object - lists_.rbegin());
  }

  // What does not fit is passed over.
  void close(bool list) {
    if (lists_.empty() || lists_.back() != list) return;
    lists_.pop_back();
    if (list) return;
    const JsonPlace::Object inner = std::move(place_.objects.back());
    place_.objects.pop_back();
    if (place_.objects.empty() || in_list()) return;
    JsonPlace::Object& outer = place_.objects.back();
    for (const auto& [key, text] : inner.texts) outer.texts[outer.key + "." + key] = text;
  }

  void string() {
    std::string text;
    while (at_ < text_.size() && text_[at_] != '"') {
      char c = text_[at_++];
      if (c == '\\' && at_ < text_.size()) {
        c = text_[at_++];
        if (c == 'n') c = '\n';
      }
      text += c;
    }
    if (at_ == text_.size()) {
      place_.in_string = true;
      place_.part = text;
      return;
    }
    ++at_;
    if (place_.objects.empty() || in_list()) return;
    JsonPlace::Object& object = place_.objects.back();
    if (object.key.empty()) {
      object.key = text;
      object.keys.push_back(text);
    } else {
      object.texts[object.key] = text;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<bool> lists_;  // of what is open: is it a list?
  JsonPlace place_;
};

}  // namespace

std::string JsonPlace::text(const std::string& key) const {
  for (const Object& object : objects | std::views::reverse) {
    if (const auto found = object.texts.find(key); found != object.texts.end()) {
      return found->second;
    }
  }
  return "";
}

JsonPlace json_place(std::string_view before) {
  return Scanner(before).run();
}

}  // namespace mjcourse
