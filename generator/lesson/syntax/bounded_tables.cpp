#include "lesson/syntax/bounded_tables.h"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm/parser.h>
#include <cmark-gfm/syntax_extension.h>

#include <string>
#include <string_view>

#include "lesson/syntax/markdown.h"
#include "lesson/syntax/table_row.h"

namespace mjcourse {
namespace {

thread_local int cells = 0;
thread_local int refused = 0;
thread_local Losses* found_losses = nullptr;

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

// The line that is read, without its end and the marks of quotes and lists before it.
std::string row_at(cmark_parser* parser, std::string_view line) {
  const auto begin = static_cast<std::size_t>(cmark_parser_get_first_nonspace(parser));
  const std::size_t end = line.find_last_not_of(" \t\r\n");
  return begin < line.size() && end != line.npos && end >= begin
             ? std::string(line.substr(begin, end + 1 - begin))
             : "";
}

// The paragraph's last line, which is a table's head where the next one opens a table.
std::string last_line(cmark_node* paragraph) {
  std::string_view text = cmark_node_get_string_content(paragraph);
  while (text.ends_with('\n')) text.remove_suffix(1);
  return std::string(text.substr(text.rfind('\n') + 1));
}

bool is_cut(const std::string& row, int line) {
  const std::optional<CuttingBar> bar = cutting_bar(row);
  if (bar)
    found_losses->push_back({Loss::Kind::cut_cell, line, row, bar->at, bar->at + 1, bar->within});
  return bar.has_value();
}

void note_row(const std::string& row, int line, int columns) {
  if (is_cut(row, line)) return;
  std::vector<RowCell> found = cells_of_row(row);
  const auto most = static_cast<std::size_t>(columns);
  const auto is_empty = [&](const RowCell& cell) {
    return std::string_view(row).substr(0, cell.end).find_last_not_of(" \t") + 1 <= cell.begin;
  };
  while (found.size() > most && is_empty(found.back()))
    found.pop_back();  // nothing is lost with it
  if (found.size() <= most) return;
  found_losses->push_back({Loss::Kind::cells, line, row, found[most].begin, found.back().end, "",
                           static_cast<int>(found.size()), columns});
}

// `head` stands above a row of dashes, at `line`.
void note_head(const std::string& head, const std::string& dashes, int line, bool is_table) {
  if (head.find('|') == head.npos || is_cut(head, line - 1) || is_table) return;
  const auto wide = static_cast<int>(cells_of_row(head).size());
  const auto columns = static_cast<int>(cells_of_row(dashes).size());
  if (wide == columns) return;
  found_losses->push_back(
      {Loss::Kind::no_table, line, dashes, 0, dashes.size(), "", wide, columns});
}

// A row of dashes, with no text above it.
void note_headless(cmark_parser* parser, std::string_view line) {
  const std::string row = columns_in(line) > 0 ? row_at(parser, line) : "";
  if (row.find('|') == row.npos) return;
  const auto columns = static_cast<int>(cells_of_row(row).size());
  found_losses->push_back(
      {Loss::Kind::headless, parser->line_number, row, 0, row.size(), "", 0, columns});
}

// `parent` is a paragraph whose line may become a table's first row, or a table; in any other no
// table begins.
cmark_node* open_bounded_table(cmark_syntax_extension* self, int indented, cmark_parser* parser,
                               cmark_node* parent, unsigned char* input, int length) {
  const std::string_view line(reinterpret_cast<char*>(input), static_cast<std::size_t>(length));
  const bool is_row = cmark_node_get_type(parent) != CMARK_NODE_PARAGRAPH;
  const int columns = is_row ? cmark_gfm_extensions_get_table_columns(parent) : columns_in(line);
  if (is_row && columns == 0) {
    if (indented == 0) note_headless(parser, line);
    return open_table(self, indented, parser, parent, input, length);
  }
  if (columns > kMostColumns || (columns > 0 && cells + columns > kMostCells)) {
    if (refused == 0) refused = parser->line_number;
    return nullptr;
  }
  const std::string row = columns > 0 ? row_at(parser, line) : "";
  const bool may_open = columns > 0 && !is_row && row.find('|') != row.npos;
  const std::string head = may_open ? last_line(parent) : "";
  cmark_node* node = open_table(self, indented, parser, parent, input, length);
  if (node != nullptr) cells += columns;
  if (may_open) {  // a paragraph that becomes a table is given back, and so is one that does not
    const bool is_table = cmark_node_get_type(parent) != CMARK_NODE_PARAGRAPH;
    note_head(head, row, parser->line_number, is_table);
  }
  if (is_row && node != nullptr) note_row(row, parser->line_number, columns);
  return node;
}

}  // namespace

void BoundedTables::teach() {
  cmark_syntax_extension* table = cmark_find_syntax_extension("table");
  open_table = table->try_opening_block;
  cmark_syntax_extension_set_open_block_func(table, open_bounded_table);
}

BoundedTables::BoundedTables(Losses& losses) {
  cells = 0;
  refused = 0;
  found_losses = &losses;
}

BoundedTables::~BoundedTables() {
  found_losses = nullptr;
}

int BoundedTables::refused_line() const {
  return refused;
}

}  // namespace mjcourse
