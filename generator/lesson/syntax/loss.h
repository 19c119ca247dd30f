// Losses: what cmark leaves out of a text's tree, or takes for mere text, without a word.
#pragma once

#include <string>
#include <vector>

namespace mjcourse {

struct Loss {
  enum class Kind {
    cells,            // of a row, behind the table's last column
    cut_cell,         // a bar ends a cell within a formula or code
    no_table,         // a row of dashes has another width than the head above it
    footnote,         // nothing refers to it
    second_footnote,  // another one of the text has its name
    headless,         // a row of dashes has no head above it
    reference,        // the definition of one that nothing names
    second_reference  // another one of the text has its name, and another address
  };
  Kind kind;
  int line;  // counted as those of the tree
  // Of a table, as it stands in the line behind the marks of quotes and lists; the reference's name
  // in its brackets.
  std::string row;
  std::size_t begin = 0, end = 0;  // what of the row is meant
  std::string what{};              // is cut: "a formula"; the footnote's or the reference's name
  int cells = 0, columns = 0;      // of the row, and of the table
};

using Losses = std::vector<Loss>;

}  // namespace mjcourse
