#include "evaluate/script_place.h"

namespace mjcourse {

Diagnostic script_diagnostic(const ScriptError& error, const LocatedText& script,
                             const SourceText& lesson) {
  const Span span =
      error.line > 0 ? script.span_at(error.line, error.column, error.width) : script.span();
  return {error.id, Severity::error, place_of(lesson, span), error.message, "", {}, error.cure};
}

}  // namespace mjcourse
