#include "base/source_text.h"

#include <algorithm>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr std::size_t kStretch = 4096;  // bytes

}  // namespace

SourceText::SourceText(std::string path, std::string text)
    : path_(std::move(path)), text_(std::move(text)), starts_{0} {
  std::size_t longest = 0;
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] != '\n') continue;
    longest = std::max(longest, i - starts_.back());
    starts_.push_back(i + 1);
  }
  if (std::max(longest, text_.size() - starts_.back()) <= kStretch) return;
  characters_.push_back(0);
  for (std::size_t end = kStretch; end <= text_.size(); end += kStretch) {
    characters_.push_back(characters_.back() +
                          count_characters(this->text().substr(end - kStretch, kStretch)));
  }
}

int SourceText::characters_before(std::size_t offset) const {
  const std::size_t stretch = offset / kStretch, start = stretch * kStretch;
  return characters_[stretch] + count_characters(text().substr(start, offset - start));
}

Position SourceText::position(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const auto number = static_cast<int>(after - starts_.begin());
  const std::size_t start = starts_[static_cast<std::size_t>(number - 1)];
  offset = std::min(offset, start + line(number).size());  // a line's end is none of its characters
  const int before = characters_.empty() ? count_characters(text().substr(start, offset - start))
                                         : characters_before(offset) - characters_before(start);
  return {number, 1 + before};
}

std::string_view SourceText::line(int line) const {
  const std::size_t begin = line_start(line);
  std::string_view rest = text().substr(begin);
  rest = rest.substr(0, rest.find('\n'));
  if (rest.ends_with('\r')) rest.remove_suffix(1);
  return rest;
}

std::size_t SourceText::line_start(int line) const {
  if (line < 1) return 0;
  const auto index = static_cast<std::size_t>(line - 1);
  return index < starts_.size() ? starts_[index] : text_.size();
}

}  // namespace mjcourse
