// The claims of the text itself: values, formulas and established facts.
#include <algorithm>
#include <utility>

#include "evaluate/claim_text.h"
#include "evaluate/lesson_claims.h"

namespace mjcourse {
namespace {

using Kind = Claim::Kind;
using Status = Claim::Status;

// What stands behind "Source:" in the last such paragraph of the callout `index`, and where that
// leads; "" without one.
std::string source_of(const Lesson& lesson, std::size_t index) {
  const auto node = std::find_if(lesson.block_of.begin(), lesson.block_of.end(),
                                 [&](const auto& known) { return known.second == index; });
  std::string source;
  cmark_node* child = cmark_node_first_child(const_cast<cmark_node*>(node->first));
  for (; child != nullptr; child = cmark_node_next(child)) {
    const std::string text = plain_text(child);
    if (!text.starts_with("Source:") || text.size() < 9) continue;
    source = text.substr(text.find_first_not_of(' ', 7));
    for (cmark_node* part = cmark_node_first_child(child); part; part = cmark_node_next(part)) {
      if (cmark_node_get_type(part) != CMARK_NODE_LINK) continue;
      source += std::string(" <") + cmark_node_get_url(part) + ">";
    }
  }
  return source;
}

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
  claim.reason = source_of(lesson_, i);
  claim.status = claim.reason.empty() ? Status::asserted : Status::cited;
  finish(std::move(claim), true, {});
}

}  // namespace mjcourse
