// Enter here from results to claims: once a course was evaluated, one Claim for each thing that it
// states.
//
// A block becomes claims in one small function for its kind, in LessonClaims (lesson_claims.h). A
// new kind of block gets a kind of Claim (claim.h), such a function, and a line in tally_of.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "evaluate/evaluate.h"

namespace mjcourse {

// Fills the claims and the tally of every lesson of `evaluation`, whose results, diagnostics and
// versions are complete. `programs` are the results of the examples by their files.
void make_claims(const Course& course, const std::filesystem::path& root,
                 const std::map<std::string, ExampleResult>& programs, Evaluation& evaluation);

}  // namespace mjcourse
