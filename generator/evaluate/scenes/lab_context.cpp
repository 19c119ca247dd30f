#include "evaluate/scenes/lab_context.h"

#include <algorithm>

namespace mjcourse {
namespace {

bool is_same(const Diagnostic& a, const Diagnostic& b) {
  return a.id == b.id && a.message == b.message && a.place.line == b.place.line &&
         a.place.column == b.place.column;
}

}  // namespace

bool LabContext::error(ScriptError error, const LocatedText& text, ScriptKind kind,
                       const LocatedText* solution) const {
  const LocatedText& define = lab_.define;
  if (define.text.empty() || kind == ScriptKind::assignment) {
    return BlockContext::error(error, text, solution);
  }
  const LineBehind place = line_behind(define.text, error.line, kind);
  error.line = place.line;
  if (place.part != LineBehind::Part::definitions) {
    return BlockContext::error(error, text, solution);
  }
  BlockContext::error(error, define, solution);
  const Diagnostic& told = diagnostics().back();
  const auto count = std::ranges::count_if(
      diagnostics(), [&](const Diagnostic& other) { return is_same(other, told); });
  if (count > 1) diagnostics().pop_back();
  return false;
}

}  // namespace mjcourse
