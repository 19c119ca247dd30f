#include "report/meaning.h"

#include <algorithm>

#include "base/text_lines.h"
#include "meanings_page.h"
#include "report/colours.h"
#include "report/wrapped.h"

namespace mjcourse {
namespace {

constexpr std::string_view kHeading = "\n### ";

std::string_view without_outer_line_ends(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of('\n'), text.size());
  return text.substr(first, text.find_last_not_of('\n') + 1 - first);
}

// Takes the marks out of one line, from the left to the right.
class PlainLine {
 public:
  explicit PlainLine(std::string_view line) : rest_(line) {}

  std::string text() {
    while (!rest_.empty()) {
      if (rest_.front() == '`') {
        add_code_span();
      } else if (rest_.starts_with("<code>")) {
        add_code_element();
      } else if (rest_.front() == '[' && rest_.find("](") != rest_.npos) {
        add_link();
      } else {
        text_ += rest_.front();
        rest_.remove_prefix(1);
      }
    }
    return text_;
  }

 private:
  // Code within more backticks than one has some of its own, and needs no others.
  void add_code_span() {
    const std::size_t marks = std::min(rest_.find_first_not_of('`'), rest_.size());
    std::size_t end = marks, closing = 0;  // where it ends, and the backticks there
    while (end < rest_.size() && closing != marks) {
      end = std::min(rest_.find('`', end + closing), rest_.size());
      closing = std::min(rest_.find_first_not_of('`', end), rest_.size()) - end;
    }
    const std::string_view code = rest_.substr(marks, end - marks);
    text_ += marks == 1 ? "`" + std::string(code) + "`" : std::string(trimmed(code));
    rest_.remove_prefix(end + closing);
  }

  void add_code_element() {
    const std::string_view open = "<code>", close = "</code>";
    const std::size_t end = std::min(rest_.find(close), rest_.size());
    text_ += "`" + std::string(rest_.substr(open.size(), end - open.size())) + "`";
    rest_.remove_prefix(std::min(end + close.size(), rest_.size()));
  }

  // "[tables](A.3#reports)" is "tables (A.3)".
  void add_link() {
    const std::size_t middle = rest_.find("](");
    const std::size_t end = std::min(rest_.find(')', middle), rest_.size() - 1);
    const std::string_view words = rest_.substr(1, middle - 1);
    const std::string_view target = rest_.substr(middle + 2, end - middle - 2);
    const std::string_view lesson = target.substr(0, target.find('#'));
    text_ += words;
    if (!lesson.empty() && words != lesson) text_ += " (" + std::string(lesson) + ")";
    rest_.remove_prefix(end + 1);
  }

  std::string_view rest_;
  std::string text_;
};

}  // namespace

std::vector<Meaning> read_meanings(std::string_view page) {
  std::vector<Meaning> all;
  for (std::size_t at = page.find(kHeading); at != page.npos;) {
    const std::size_t id = at + kHeading.size();
    const std::size_t end = std::min(page.find('\n', id), page.size());
    at = page.find(kHeading, end);
    // The next section may be of a higher level.
    const std::size_t stop = std::min(page.find("\n## ", end), at);
    all.push_back(
        {page.substr(id, end - id), without_outer_line_ends(page.substr(end, stop - end))});
  }
  return all;
}

const std::vector<Meaning>& meanings() {
  static const std::vector<Meaning> all = read_meanings(kMeaningsPage);
  return all;
}

const Meaning* meaning_of(std::string_view id) {
  const auto found = std::find_if(meanings().begin(), meanings().end(),
                                  [&](const Meaning& meaning) { return meaning.id == id; });
  return found == meanings().end() ? nullptr : &*found;
}

bool is_like_id(std::string_view text) {
  return text.starts_with("E-") || text.starts_with("W-");
}

std::string plain_text_of(const Meaning& meaning) {
  std::string text;
  for (std::string_view line : lines_of(meaning.text)) {
    if (line.empty()) continue;
    if (line.starts_with("- ")) line.remove_prefix(2);
    text += PlainLine(line).text() + "\n";
  }
  return text;
}

std::string format_for_terminal(const Meaning& meaning, const TerminalStyle& style) {
  constexpr int indent = 2;
  constexpr std::string_view wrong = "wrong: ", right = "right: ";
  const auto coloured = [&](std::string_view colour, std::string_view words) {
    return style.colours ? std::string(colour) + std::string(words) + std::string(kPlain)
                         : std::string(words);
  };
  const bool error = meaning.id.starts_with("E-");
  std::string text = coloured(error ? kRed : kYellow, error ? "error " : "warning ") +
                     coloured(kBold, meaning.id) + "\n";
  const std::string plain = plain_text_of(meaning);
  for (std::string_view line : lines_of(plain)) {
    const bool example = line.starts_with(wrong) || line.starts_with(right);
    if (!line.starts_with(right)) text += '\n';
    text += std::string(indent, ' ');
    int at = indent;
    if (example) {
      text += coloured(line.starts_with(wrong) ? kRed : kGreen, line.substr(0, wrong.size()));
      line.remove_prefix(wrong.size());
      at += static_cast<int>(wrong.size());
    }
    text += wrapped(line, style.width, at, at) + "\n";
  }
  return text;
}

}  // namespace mjcourse
