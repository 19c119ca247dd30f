#include "lesson/blocks/read_losses.h"

#include <algorithm>

#include "base/counted.h"

namespace mjcourse {
namespace {

// Where the lines of a text begin, of which each is mostly behind the one asked for before.
class LineStarts {
 public:
  explicit LineStarts(const std::string& text) : text_(text) {}

  // Of `line`, from 1.
  std::size_t of(int line) {
    if (line < line_) {
      line_ = 1;
      at_ = 0;
    }
    for (; line_ < line && at_ < text_.size(); ++line_) {
      at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
    }
    return at_;
  }

 private:
  const std::string& text_;
  int line_ = 1;
  std::size_t at_ = 0;
};

// "| | |"
std::string empty_head(int columns) {
  std::string head = "|";
  for (int i = 0; i < columns; ++i) head += " |";
  return head;
}

void tell_loss(const Loss& loss, Span span, Reading& reading) {
  switch (loss.kind) {
    case Loss::Kind::cells:
      return reading.error(
          "E-table-cells", span,
          "this row has " + counted(loss.cells, "cell") + ", and its table " +
              counted(loss.columns, "column") + ": the rest is not in the page",
          "give the head a cell for each column; for a bar within a cell, write `\\|`");
    case Loss::Kind::cut_cell:
      return reading.error(
          "E-table-cells", span, "this `|` ends the cell in the middle of " + loss.what,
          "in a table, write `\\|` for a bar that ends no cell, and `\\$` for a dollar as text");
    case Loss::Kind::no_table:
      return reading.warning("W-table-head", span,
                             "this is not a table: its head has " + counted(loss.cells, "cell") +
                                 ", and the row of dashes below it " + std::to_string(loss.columns),
                             "give both as many; for a bar within a cell, write `\\|`");
    case Loss::Kind::headless:
      return reading.warning(
          "W-table-head", span, "this is not a table: no head stands above the row of dashes",
          "put a row above it; for a head without words, `" + empty_head(loss.columns) + "`");
    case Loss::Kind::reference:
      return reading.warning(
          "W-reference-unused", span,
          "nothing uses the reference `" + loss.what + "`, so its line is not in the page",
          "write `[…][" + loss.what +
              "]` where it belongs, or remove it; for "
              "the line as text, write `\\" +
              loss.row + "`");
    case Loss::Kind::second_reference:
      return reading.error("E-reference-name", span,
                           "another reference is called `" + loss.what +
                               "`, and each link by that name leads to its address",
                           "give it a name of its own; capital and small letters are the same");
    case Loss::Kind::footnote:
      return reading.warning("W-footnote-unused", span,
                             "nothing refers to the footnote `" + loss.what +
                                 "`, so it is not in the page, and nothing in it is checked",
                             "write `[^" + loss.what + "]` where it belongs, or remove it");
    case Loss::Kind::second_footnote:
      return refuse_second_footnote(loss.what, span, reading);
  }
}

}  // namespace

void tell_losses(const Losses& losses, const LocatedText& text, Reading& reading) {
  LineStarts starts(text.text);
  for (const Loss& loss : losses) {
    const std::size_t start = starts.of(loss.line);
    const bool is_footnote =
        loss.kind == Loss::Kind::footnote || loss.kind == Loss::Kind::second_footnote;
    const std::string mark = is_footnote ? "[^" + loss.what + "]" : loss.row;
    const std::size_t at = std::min(text.text.find(mark, start), text.text.size());
    const Span span =
        is_footnote ? text.span(at, at + mark.size()) : text.span(at + loss.begin, at + loss.end);
    tell_loss(loss, span, reading);
  }
}

void refuse_second_footnote(const std::string& name, Span span, Reading& reading) {
  reading.error("E-footnote-name", span, "another footnote of this page is called `" + name + "`",
                "give it a name of its own");
}

}  // namespace mjcourse
