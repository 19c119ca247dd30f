#include "evaluate/context/script_place.h"

namespace mjcourse {

Diagnostic script_diagnostic(const ScriptError& error, const LocatedText& script,
                             const SourceText& lesson) {
  const Span span =
      error.line > 0 ? script.span_at(error.line, error.column, error.width) : script.span();
  return error_at(place_of(lesson, span), error.id, error.message, error.cure);
}

}  // namespace mjcourse
