#include "course/yaml_insertion.h"

#include <string_view>

#include "course/flow_list.h"

namespace mjcourse {
namespace {

// Where the line around `at` begins, and where the next one does.
std::size_t line_start(std::string_view text, std::size_t at) {
  const std::size_t before = at == 0 ? text.npos : text.rfind('\n', at - 1);
  return before == text.npos ? 0 : before + 1;
}
std::size_t next_line(std::string_view text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return end == text.npos ? text.size() : end + 1;
}

std::string_view line_end(std::string_view text) {
  return text.find("\r\n") == text.npos ? "\n" : "\r\n";
}

std::size_t place_of(const YAML::Node& node) {
  return static_cast<std::size_t>(node.Mark().pos);
}

// An item of a block sequence: the column of its dash, and its lines.
struct BlockItem {
  std::size_t indent, begin, end;
};

// The lines of an item are all that are indented deeper than its dash. Comments and empty lines
// behind the last of its own belong to what follows.
std::optional<BlockItem> find_block_item(std::string_view text, const YAML::Node& node) {
  const std::size_t at = place_of(node), begin = line_start(text, at);
  const std::size_t dash = text.find_first_not_of(' ', begin);
  // What stands between the dash and the item, a tag or another dash, is not understood.
  if (dash >= at || text[dash] != '-' || text.find_first_not_of(' ', dash + 1) != at) {
    return std::nullopt;
  }
  const std::size_t indent = dash - begin;
  std::size_t end = next_line(text, begin);
  for (std::size_t line = end; line < text.size(); line = next_line(text, line)) {
    const std::size_t word = text.find_first_not_of(" \r", line);
    if (word == text.npos) break;
    if (text[word] == '\n') continue;
    if (word - line > indent) {
      end = next_line(text, line);
    } else if (text[word] != '#') {
      break;
    }
  }
  return BlockItem{indent, begin, end};
}

// `lines` as they stand at `at`, the beginning of a line or the end of a text without one.
std::string insert_lines(const std::string& text, std::size_t at, const std::string& lines) {
  const std::string eol(line_end(text));
  const bool open = at > 0 && text[at - 1] != '\n';
  return text.substr(0, at) + (open ? eol + lines : lines + eol) + text.substr(at);
}

std::optional<std::string> insert_block_item(const std::string& text, const YAML::Node& sequence,
                                             std::size_t index, const YamlItem& item) {
  const std::optional<BlockItem> first = find_block_item(text, sequence[0]);
  const auto beside = find_block_item(text, sequence[index == 0 ? 0 : index - 1]);
  if (!first || !beside) return std::nullopt;
  const std::string eol(line_end(text)), indent(beside->indent, ' ');
  std::string lines;
  for (const std::string& line : item.lines) {
    lines += lines.empty() ? indent + "- " : eol + indent + "  ";
    lines += line;
  }
  // Items with an empty line between them get one more of both.
  const bool apart = sequence.size() > 1 &&
                     text.find_first_not_of('\r', first->end) == text.find('\n', first->end);
  if (index == 0) return insert_lines(text, beside->begin, apart ? lines + eol : lines);
  return insert_lines(text, beside->end, apart ? eol + lines : lines);
}

}  // namespace

std::optional<std::string> insert_item(const std::string& text, const YAML::Node& sequence,
                                       std::size_t index, const YamlItem& item) {
  if (sequence.Style() == YAML::EmitterStyle::Block && sequence.size() > 0) {
    return insert_block_item(text, sequence, index, item);
  }
  std::vector<std::size_t> items;
  for (const YAML::Node& one : sequence) items.push_back(place_of(one));
  return insert_into_flow_list(text, place_of(sequence), items, index, item.flow);
}

std::optional<std::string> append_line(const std::string& text, const YAML::Node& item,
                                       const std::string& line) {
  const std::optional<BlockItem> block = find_block_item(text, item);
  if (!block) return std::nullopt;
  const std::size_t indent = place_of(item) - block->begin;
  return insert_lines(text, block->end, std::string(indent, ' ') + line);
}

}  // namespace mjcourse
