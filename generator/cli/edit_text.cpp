#include "cli/edit_text.h"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <vector>

#include "base/utf8.h"
#include "report/colours.h"
#include "report/diff_text.h"

namespace mjcourse {
namespace {

bool is_text(std::string_view bytes) {
  return bytes.find('\0') == bytes.npos && !find_invalid_utf8(bytes);
}

std::string size_text(std::size_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + (bytes == 1 ? " byte" : " bytes");
  char text[32];
  std::snprintf(text, sizeof text, "%.1f KB", static_cast<double>(bytes) / 1000);
  return text;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    if (lines.back().ends_with('\r')) lines.back().remove_suffix(1);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string indented(const std::string& lines) {
  std::string text;
  for (const std::string_view line : lines_of(lines)) text += "  " + std::string(line) + "\n";
  return text;
}

}  // namespace

std::string edit_text(const FileEdit& edit, bool colours) {
  std::string what;
  for (const Diagnostic* cure : edit.cures) {
    if (what.find(cure->edit->what) != what.npos) continue;
    what += (what.empty() ? "" : ", ") + cure->edit->what;
  }
  const std::string title = edit.file + ": " + what;
  std::string text = (colours ? std::string(kBold) + title + std::string(kPlain) : title) + "\n";
  if (!is_text(edit.after) || !is_text(edit.before.value_or(""))) {
    return text + "  writes " + edit.file + " (" + size_text(edit.after.size()) + ")\n";
  }
  const SameLine same = [](std::string_view a, std::string_view b) { return a == b; };
  const std::vector<DiffLine> lines =
      line_diff(lines_of(edit.before.value_or("")), lines_of(edit.after), same);
  DiffStyle style;
  style.colours = colours;
  if (lines.empty()) return text + "  the ends of its lines\n";
  return text + indented(diff_text(lines, same, style));
}

}  // namespace mjcourse
