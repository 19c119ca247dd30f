#include "report/changed_words.h"

#include <algorithm>
#include <vector>

#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostWords = 200;  // of a line that is looked into

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

// A line to stand beneath `line`, with a mark under each of its words that is not kept. A tab stays
// one, so that the marks stand where they should.
std::string marks_beneath(std::string_view line, const std::vector<std::string_view>& words,
                          const std::vector<char>& kept) {
  std::string marks;
  std::size_t at = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (kept[i] != 0) continue;
    const auto begin = static_cast<std::size_t>(words[i].data() - line.data());
    for (; at < begin; ++at) {
      if (line[at] == '\t') {
        marks += '\t';
      } else if (count_characters(line.substr(at, 1)) > 0) {
        marks += ' ';
      }
    }
    const auto width = static_cast<std::size_t>(std::max(1, count_characters(words[i])));
    marks += "^" + std::string(width - 1, '~');
    at += words[i].size();
  }
  return marks;
}

}  // namespace

ChangedWords changed_words(std::string_view before, std::string_view after) {
  const std::vector<std::string_view> a = words_of(before), b = words_of(after);
  if (a.empty() || b.empty() || a.size() > kMostWords || b.size() > kMostWords) return {};
  // common[i][j]: the most words that a[i..] and b[j..] have in common, in order.
  std::vector<std::vector<int>> common(a.size() + 1, std::vector<int>(b.size() + 1, 0));
  for (std::size_t i = a.size(); i-- > 0;) {
    for (std::size_t j = b.size(); j-- > 0;) {
      common[i][j] =
          a[i] == b[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
    }
  }
  std::vector<char> kept_a(a.size(), 0), kept_b(b.size(), 0);
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i] == b[j]) {
      kept_a[i++] = kept_b[j++] = 1;
    } else if (common[i + 1][j] >= common[i][j + 1]) {
      ++i;
    } else {
      ++j;
    }
  }
  const double alike = 2.0 * common[0][0] / static_cast<double>(a.size() + b.size());
  return {alike, marks_beneath(before, a, kept_a), marks_beneath(after, b, kept_b)};
}

}  // namespace mjcourse
