#include "evaluate/claims/prose_claims.h"

#include <utility>

#include "evaluate/claims/claim_text.h"

namespace mjcourse {
namespace {

using Kind = Claim::Kind;
using Status = Claim::Status;

}  // namespace

void claim(const InlineValue& value, std::size_t i, ClaimContext& context) {
  Claim made = context.begin(Kind::value, i, value.expression.text + " of " + value.source.text,
                             {value.source.span().begin, value.expression.span().end});
  const auto* result = context.results.get<ValueResult>(i);
  if (result != nullptr) {
    made.how = (result->origin.ends_with(".cpp")
                    ? "reported by " + value.source.text + ".cpp: "
                    : "computed from " + value.source.text + ".xml in its initial state: ") +
               result->text;
  }
  context.finish(std::move(made), result != nullptr,
                 {value.format.text, result == nullptr ? "" : result->text,
                  context.sources.model(value.source.text)});
}

void claim(const Math& math, std::size_t i, ClaimContext& context) {
  Claim made = context.begin(Kind::formula, i, as_title(math.tex.text), math.tex.span());
  made.how = "typeset by KaTeX " + context.versions().katex;
  made.limits = "that it is TeX, and not that it is true";
  const auto* result = context.results.get<FormulaResult>(i);
  context.finish(std::move(made), result != nullptr, {result == nullptr ? "" : result->markup});
}

void claim(const Callout& callout, std::size_t i, ClaimContext& context) {
  if (callout.kind != "established") return;
  Claim made = context.begin(Kind::citation, i,
                             callout.title ? as_title(plain_text(callout.title.get())) : "a fact",
                             callout.span);
  made.reason = callout.source;
  made.status = made.reason.empty() ? Status::asserted : Status::cited;
  context.finish(std::move(made), true, {});
}

}  // namespace mjcourse
