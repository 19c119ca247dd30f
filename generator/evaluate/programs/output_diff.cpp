#include "evaluate/programs/output_diff.h"

#include <algorithm>

#include "base/text_lines.h"
#include "base/utf8.h"
#include "evaluate/programs/decimal.h"
#include "evaluate/programs/printed_number.h"

namespace mjcourse {
namespace {

std::string_view trimmed_right(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  return text.substr(0, last == text.npos ? 0 : last + 1);
}

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines = lines_of(trimmed_right(text));
  for (std::string_view& line : lines) line = trimmed_right(line);
  return lines;
}

// Walks a stated line beside the real one. Both are kept whole: whether digits are a number depends
// on what stands around them.
class LineMatch {
 public:
  LineMatch(std::string_view stated, std::string_view real, const std::optional<Decimal>& tolerance,
            Retrials& retrials)
      : stated_(stated), real_(real), tolerance_(tolerance), retrials_(retrials) {}

  bool agrees() {
    while (at_ < stated_.size() || real_at_ < real_.size()) {
      if (stated_.substr(at_).starts_with("[..]")) {
        at_ += 4;
        after_gap_ = at_;
        gap_end_ = real_at_;
      } else if (!step() && !widen_gap()) {
        return false;
      }
    }
    return true;
  }

 private:
  // Take what agrees next from both; false when nothing does.
  bool step() {
    if (at_ == stated_.size() || real_at_ == real_.size()) return false;
    if (stated_[at_] == ' ' || real_[real_at_] == ' ') return step_over_spaces();
    // The real line first: behind a gap, the stated one is looked at again and again.
    const auto real_number = PrintedNumber::find(real_, real_at_);
    const auto number = real_number ? PrintedNumber::find(stated_, at_) : std::nullopt;
    if (number && number->agrees_with(*real_number, tolerance_)) {
      at_ += number->length();
      real_at_ += real_number->length();
      return true;
    }
    // Other numbers begin alike where a `[..]` stands for the end of one: "id 12[..]".
    if (stated_[at_] != real_[real_at_]) return false;
    ++at_, ++real_at_;
    return true;
  }

  // A column of numbers may shift by a sign or a digit: any space matches any space, and none where
  // only the first column shifts (" 0.1" and "-0.0").
  bool step_over_spaces() {
    const bool both = stated_[at_] == real_[real_at_];
    if (!both && (is_within(stated_, at_) || is_within(real_, real_at_))) return false;
    const std::size_t word = word_from(stated_, at_), real_word = word_from(real_, real_at_);
    if (!both && !(PrintedNumber::find(real_, real_word) && PrintedNumber::find(stated_, word))) {
      return false;
    }
    at_ = word;
    real_at_ = real_word;
    return true;
  }

  // Where the first character from `at` on stands that is no space.
  static std::size_t word_from(std::string_view line, std::size_t at) {
    return std::min(line.find_first_not_of(' ', at), line.size());
  }
  // Behind a word or a space, where no column begins.
  static bool is_within(std::string_view line, std::size_t at) {
    return at > 0 && (is_word_character(line[at - 1]) || line[at - 1] == ' ');
  }

  // Let the last `[..]` stand for one character more, and try again behind it. Where a space must
  // follow, all spaces in a row are one try.
  bool widen_gap() {
    if (!after_gap_ || gap_end_ == real_.size()) return false;
    const std::size_t back = real_at_ - gap_end_;
    retrials_.left -= std::min(back, retrials_.left);
    if (retrials_.left == 0) return false;
    at_ = *after_gap_;
    const bool spaces = at_ < stated_.size() && stated_[at_] == ' ' && real_[gap_end_] == ' ';
    gap_end_ = spaces ? word_from(real_, gap_end_) : gap_end_ + 1;
    real_at_ = gap_end_;
    return true;
  }

  std::string_view stated_, real_;
  const std::optional<Decimal>& tolerance_;
  Retrials& retrials_;
  std::size_t at_ = 0, real_at_ = 0;      // how far both are taken
  std::optional<std::size_t> after_gap_;  // where the stated line goes on behind the last `[..]`
  std::size_t gap_end_ = 0;               // where that `[..]` ends in the real line
};

bool agree(std::string_view stated, std::string_view real, const std::optional<Decimal>& tolerance,
           Retrials& retrials) {
  return LineMatch(trimmed_right(stated), trimmed_right(real), tolerance, retrials).agrees();
}

std::optional<Decimal> exact(std::optional<double> tolerance) {
  return tolerance ? std::optional<Decimal>(*tolerance) : std::nullopt;
}

}  // namespace

bool lines_agree(std::string_view stated, std::string_view real, std::optional<double> tolerance,
                 Retrials& retrials) {
  return agree(stated, real, exact(tolerance), retrials);
}

std::vector<DiffLine> output_changes(std::string_view stated, std::string_view real,
                                     std::optional<double> tolerance, Retrials& retrials) {
  const std::optional<Decimal> most = exact(tolerance);
  return line_diff(
      split_lines(stated), split_lines(real),
      [&](std::string_view a, std::string_view b) { return agree(a, b, most, retrials); });
}

}  // namespace mjcourse
