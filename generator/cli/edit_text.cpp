#include "cli/edit_text.h"

#include <cstdio>
#include <string_view>
#include <vector>

#include "base/counted.h"
#include "base/text_lines.h"
#include "base/utf8.h"
#include "cli/size.h"
#include "report/colours.h"
#include "report/diff_text.h"

namespace mjcourse {
namespace {

bool is_text(std::string_view bytes) {
  return bytes.find('\0') == bytes.npos && !find_invalid_utf8(bytes);
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
  const std::string text =
      (colours ? std::string(kBold) + title + std::string(kPlain) : title) + "\n";
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
