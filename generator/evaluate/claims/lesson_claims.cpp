#include "evaluate/claims/lesson_claims.h"

#include <algorithm>
#include <tuple>
#include <variant>

namespace mjcourse {

Claims LessonClaims::run() {
  for (std::size_t i = 0; i < lesson_.blocks.size(); ++i) {
    std::visit([&](const auto& block) { add(i, block); }, lesson_.blocks[i]);
  }
  return std::move(claims_);
}

Claim LessonClaims::begin(Claim::Kind kind, std::size_t block, std::string what,
                          Span extent) const {
  Claim claim;
  claim.kind = kind;
  claim.status = Claim::Status::proved;
  claim.block = block;
  claim.what = std::move(what);
  claim.extent = extent;
  claim.place = place_of(*lesson_.source, extent);
  const auto seconds = results_.seconds.find(block);
  if (seconds != results_.seconds.end()) claim.seconds = seconds->second;
  return claim;
}

bool LessonClaims::has_error(Span extent) const {
  const Position begin = lesson_.source->position(extent.begin);
  const Position end = lesson_.source->position(extent.end);
  return std::any_of(
      evaluation_.diagnostics.begin(), evaluation_.diagnostics.end(), [&](const Diagnostic& d) {
        const auto at = std::tie(d.place.line, d.place.column);
        return d.severity == Severity::error && d.place.file == lesson_.source->path() &&
               at >= std::tie(begin.line, begin.column) && at <= std::tie(end.line, end.column);
      });
}

std::string LessonClaims::written(Span span) const {
  return std::string(lesson_.source->text().substr(span.begin, span.end - span.begin));
}

void LessonClaims::finish(Claim claim, bool found, const std::vector<std::string>& parts) {
  const bool wrong = has_error(claim.extent);
  if (!found || (wrong && claim.status == Claim::Status::proved)) {
    claim.status = Claim::Status::failed;
    claim.how = claim.limits = "";
    claim.reason = wrong ? "" : "what it rests on failed";
  }
  claim.key = hash_of({name_of(claim.kind), name_of(claim.status), claim.what, claim.how,
                       claim.limits, claim.reason, written(claim.extent), versions().mjcourse,
                       versions().mujoco, hash_of(parts)});
  claims_.push_back(std::move(claim));
}

}  // namespace mjcourse
