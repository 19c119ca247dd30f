// The claims of the text itself: values, formulas and established facts.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#include <utility>

#include "evaluate/claims/claim_text.h"
#include "evaluate/claims/lesson_claims.h"

namespace mjcourse {
namespace {

using Kind = Claim::Kind;
using Status = Claim::Status;

}  // namespace

void LessonClaims::add(std::size_t i, const InlineValue& value) {
  Claim claim = begin(Kind::value, i, value.expression.text + " of " + value.source.text,
                      {value.source.span().begin, value.expression.span().end});
  const auto* result = results_.get<ValueResult>(i);
  if (result != nullptr) {
    claim.how = (result->origin.ends_with(".cpp")
                     ? "reported by " + value.source.text + ".cpp: "
                     : "computed from " + value.source.text + ".xml in its initial state: ") +
                result->text;
  }
  finish(std::move(claim), result != nullptr,
         {value.format.text, result == nullptr ? "" : result->text,
          sources_.model(value.source.text)});
}

void LessonClaims::add(std::size_t i, const Math& math) {
  Claim claim = begin(Kind::formula, i, as_title(math.tex.text), math.tex.span());
  claim.how = "typeset by KaTeX " + versions().katex;
  claim.limits = "that it is TeX, and not that it is true";
  const auto* result = results_.get<FormulaResult>(i);
  finish(std::move(claim), result != nullptr, {result == nullptr ? "" : result->markup});
}

void LessonClaims::add(std::size_t i, const Callout& callout) {
  if (callout.kind != "established") return;
  Claim claim =
      begin(Kind::citation, i, callout.title ? as_title(plain_text(callout.title.get())) : "a fact",
            callout.span);
  claim.reason = callout.source;
  claim.status = claim.reason.empty() ? Status::asserted : Status::cited;
  finish(std::move(claim), true, {});
}

}  // namespace mjcourse
