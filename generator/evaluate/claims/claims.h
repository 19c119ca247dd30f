// Enter here from results to claims: once a course was evaluated, one Claim for each thing that it
// states.
//
// A block becomes claims in one small function for its kind, claim() (claim_context.h). A
// new kind of block gets a kind of Claim (claim.h), such a function, and a line in tally_of.
#pragma once

#include <map>
#include <string>

#include "evaluate/claims/claim_sources.h"
#include "findings/evaluation.h"

namespace mjcourse {

// Fills the claims and the tally of every lesson of `evaluation`, whose results, diagnostics and
// versions are complete; of a lesson of which an outline is kept, the tally alone. `programs` are
// the results of the examples by their files. Works on `threads`.
void make_claims(const Course& course, ClaimSources& sources,
                 const std::map<std::string, ExampleResult>& programs, std::size_t threads,
                 Evaluation& evaluation);

// The claims of a lesson of which an outline was kept, and which was reloaded.
Claims claims_of_prose(const Lesson& lesson, const Evaluation& evaluation);

// Fills in what make_claims left out, and keeps those lessons' blocks, for a caller that looks at
// all lessons at once.
void claim_prose(Course& course, const Files& files, Evaluation& evaluation);

}  // namespace mjcourse
