#include "evaluate/claims/strict.h"

namespace mjcourse {
namespace {

Diagnostic asserted(const Claim& claim) {
  if (claim.kind == Claim::Kind::citation) {
    return error_at(claim.place, "E-strict-asserted",
                    "nothing says where this established fact is from",
                    "end the callout with a paragraph `Source: …`");
  }
  if (claim.kind == Claim::Kind::image) {
    return error_at(claim.place, "E-strict-asserted", "nothing says where this picture is from",
                    "say it after the file: `![…](picture.png \"drawn by …\")`");
  }
  return error_at(claim.place, "E-strict-asserted",
                  "the answer of " + claim.what.substr(0, claim.what.find(':')) +
                      " is only asserted, and nothing says why",
                  "find it again in \"verify\"; or say why nothing can: "
                  "`\"verify\": [{\"because\": \"…\"}]`");
}

Diagnostic unchecked(const Claim& claim) {
  return error_at(claim.place, "E-strict-unchecked", "nobody runs this code, and nothing says why",
                  "let the build run it; or say why it cannot: `unchecked because=\"…\"`");
}

}  // namespace

Diagnostics unreasoned(const Claims& claims) {
  Diagnostics found;
  for (const Claim& claim : claims) {
    if (!claim.reason.empty()) continue;
    if (claim.status == Claim::Status::asserted) found.push_back(asserted(claim));
    if (claim.status == Claim::Status::unchecked) found.push_back(unchecked(claim));
  }
  return found;
}

}  // namespace mjcourse
