#include "evaluate/scenes/lab_context.h"

#include <algorithm>

#include "script/author_text.h"

namespace mjcourse {
namespace {

bool is_same(const Diagnostic& a, const Diagnostic& b) {
  return a.id == b.id && a.message == b.message && a.place.line == b.place.line &&
         a.place.column == b.place.column;
}

}  // namespace

void LabContext::sharpen(const LocatedText& text, ScriptError& error) const {
  if (doubtful_ == nullptr) return;
  for (const auto& [script, told] : *doubtful_) {
    if (script->text != text.text || told.id != error.id) continue;
    const bool is_placed = told.id == "E-script-syntax" && told.line > 0;
    if (is_placed && !error.message.starts_with(kTooEarly)) {
      error.line = told.line;
      error.column = told.column;
      error.width = told.width;
    }
    if (told.message == error.message && !told.cure.empty()) error.cure = told.cure;
  }
}

bool LabContext::error(ScriptError error, const LocatedText& text, ScriptKind kind,
                       const LocatedText* solution) const {
  if (kind == ScriptKind::assignment) return BlockContext::error(error, text, solution);
  const LocatedText& define = lab_.define;
  LineBehind place{LineBehind::Part::script, error.line};
  const bool is_behind = kind != ScriptKind::definitions && !define.text.empty();
  if (is_behind) place = line_behind(define.text, error.line, kind);
  error.line = place.line;
  if (place.part != LineBehind::Part::definitions) {
    const AuthorText own(text.text);
    if (place.line > own.lines().line_count()) own.point_at_end(error);
    sharpen(text, error);
    return BlockContext::error(error, text, solution);
  }
  sharpen(define, error);
  BlockContext::error(error, define, solution);
  const Diagnostic& told = diagnostics().back();
  const auto count = std::ranges::count_if(
      diagnostics(), [&](const Diagnostic& other) { return is_same(other, told); });
  if (count > 1) diagnostics().pop_back();
  return false;
}

}  // namespace mjcourse
