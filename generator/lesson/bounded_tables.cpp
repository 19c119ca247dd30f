#include "lesson/bounded_tables.h"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm/parser.h>
#include <cmark-gfm/syntax_extension.h>

#include <string_view>

#include "lesson/markdown.h"

namespace mjcourse {
namespace {

thread_local int cells = 0;
thread_local int refused = 0;

cmark_open_block_func open_table = nullptr;

// How many columns the line may open a table with: the dashes of one that says how they are
// aligned, `|---|:-:|`; 0 for any other.
int columns_in(std::string_view line) {
  if (line.find_first_not_of(" \t\r\n|:->") != line.npos) return 0;
  if (line.find('|') == line.npos) return 1;
  int columns = 0;
  for (std::size_t at = 0; (at = line.find('-', at)) != line.npos; ++columns) {
    at = line.find_first_not_of('-', at);
  }
  return columns;
}

// `parent` is a paragraph whose line may become a table's first row, or a table.
cmark_node* open_bounded_table(cmark_syntax_extension* self, int indented, cmark_parser* parser,
                               cmark_node* parent, unsigned char* input, int length) {
  const std::string_view line(reinterpret_cast<char*>(input), static_cast<std::size_t>(length));
  const bool is_row = cmark_node_get_type(parent) != CMARK_NODE_PARAGRAPH;
  const int columns = is_row ? cmark_gfm_extensions_get_table_columns(parent) : columns_in(line);
  if (columns > kMostColumns || (columns > 0 && cells + columns > kMostCells)) {
    if (refused == 0) refused = parser->line_number;
    return nullptr;
  }
  cmark_node* node = open_table(self, indented, parser, parent, input, length);
  if (node != nullptr) cells += columns;
  return node;
}

}  // namespace

void BoundedTables::teach() {
  cmark_syntax_extension* table = cmark_find_syntax_extension("table");
  open_table = table->try_opening_block;
  cmark_syntax_extension_set_open_block_func(table, open_bounded_table);
}

BoundedTables::BoundedTables() {
  cells = 0;
  refused = 0;
}

int BoundedTables::refused_line() const {
  return refused;
}

}  // namespace mjcourse
