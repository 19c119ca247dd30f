// ProsePlace: what an author is about to name at the end of a line, outside of JSON: a fence's
// kind, a model, a link's target, a term, a value.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

struct ProsePlace {
  enum class Kind {
    fence,    // behind the marks of a fence
    option,   // behind its first word; `of` is what stands before: "cpp file=examples/a.cpp "
    choice,   // what an option is: "error" of `expect=error`; `of` has the option last, without `=`
    model,    // `model=` of one, `model:` of a link
    program,  // `output=`
    file,     // `file=`
    link,     // `](`
    heading,  // `](1.3#`; `of` is the lesson's number, "" for this one
    api,      // `](api:`
    term,     // `[[`
    source,   // a value's, behind `{` in a code span
    value,    // behind `{of} `: an expression, or a result's name
    callout   // behind `> [!`
  };
  Kind kind;
  std::string of = {};
  std::string part = {};  // of the name, so far
};

// `before`: the line up to the place; `in_fence`: it stands in the body of one. Nothing where
// nothing is named.
std::optional<ProsePlace> prose_place(std::string_view before, bool in_fence);

}  // namespace mjcourse
