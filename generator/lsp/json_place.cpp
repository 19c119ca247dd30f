#include "lsp/json_place.h"

#include <ranges>
#include <utility>

#include "lesson/json/json_depth.h"

namespace mjcourse {
namespace {

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  JsonPlace run() {
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if ((c == '{' || c == '[') && lists_.size() == kDeepestJson) return {};
      if (c == '"') {
        string();
      } else if (c == '{') {
        place_.objects.emplace_back().lists = lists();
        lists_.push_back(0);
      } else if (c == '[') {
        lists_.push_back(lists() + 1);
      } else if (c == '}' || c == ']') {
        close(c == ']');
      } else if (c == ',' && !in_list() && !place_.objects.empty()) {
        place_.objects.back().key.clear();
      }
    }
    place_.lists = lists();
    return std::move(place_);
  }

 private:
  bool in_list() const { return lists() > 0; }

  // Within the innermost object.
  int lists() const { return lists_.empty() ? 0 : lists_.back(); }

  // What does not fit is passed over.
  void close(bool list) {
    if (lists_.empty() || in_list() != list) return;
    lists_.pop_back();
    if (list) return;
    JsonPlace::Object inner = std::move(place_.objects.back());
    place_.objects.pop_back();
    if (place_.objects.empty() || in_list()) return;
    JsonPlace::Object& outer = place_.objects.back();
    outer.within[outer.key] = std::move(inner.texts);
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
  std::vector<int> lists_;  // of what is open: in how many lists its inside is, in a row
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

std::string JsonPlace::text_within(const std::string& object, const std::string& key) const {
  for (const Object& outer : objects | std::views::reverse) {
    const auto inner = outer.within.find(object);
    if (inner == outer.within.end()) continue;
    if (const auto found = inner->second.find(key); found != inner->second.end()) {
      return found->second;
    }
  }
  return "";
}

JsonPlace json_place(std::string_view before) {
  return Scanner(before).run();
}

}  // namespace mjcourse
