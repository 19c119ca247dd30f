#include "evaluate/claims/claim_context.h"

#include <algorithm>
#include <tuple>

namespace mjcourse {
namespace {

bool has_error(Span extent, const Lesson& lesson, const Diagnostics& diagnostics) {
  const Position begin = lesson.source->position(extent.begin);
  const Position end = lesson.source->position(extent.end);
  return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& d) {
    const auto at = std::tie(d.place.line, d.place.column);
    return d.severity == Severity::error && d.place.file == lesson.source->path() &&
           at >= std::tie(begin.line, begin.column) && at <= std::tie(end.line, end.column);
  });
}

}  // namespace

Claim ClaimContext::begin(Claim::Kind kind, std::size_t block, std::string what,
                          Span extent) const {
  Claim claim;
  claim.kind = kind;
  claim.status = Claim::Status::proved;
  claim.block = block;
  claim.what = std::move(what);
  claim.extent = extent;
  claim.place = place_of(*lesson.source, extent);
  const auto seconds = results.seconds.find(block);
  if (seconds != results.seconds.end()) claim.seconds = seconds->second;
  return claim;
}

std::string ClaimContext::written(Span span) const {
  return std::string(lesson.source->text().substr(span.begin, span.end - span.begin));
}

void ClaimContext::finish(Claim claim, bool found, const std::vector<std::string>& parts) {
  const bool wrong = has_error(claim.extent, lesson, evaluation.diagnostics);
  if (!found || (wrong && claim.status == Claim::Status::proved)) {
    claim.status = Claim::Status::failed;
    claim.how = claim.limits = "";
    claim.reason = wrong ? "" : "what it rests on failed";
  }
  claim.key = hash_of({name_of(claim.kind), name_of(claim.status), claim.what, claim.how,
                       claim.limits, claim.reason, written(claim.extent), versions().mjcourse,
                       versions().mujoco, hash_of(parts)});
  claims.push_back(std::move(claim));
}

}  // namespace mjcourse
