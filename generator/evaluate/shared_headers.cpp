#include "evaluate/shared_headers.h"

#include <map>

#include "base/counted.h"

namespace mjcourse {
namespace {

constexpr std::size_t kFewPrograms = 2, kManyPrograms = 40;

}  // namespace

std::string SharedHeader::what() const {
  return "compile once what " + counted(programs, "program") + " include";
}

std::vector<SharedHeader> shared_headers(const RunContext& run_context,
                                         const std::vector<const Task*>& waiting) {
  if (waiting.empty() || run_context.why_nothing_runs()) return {};
  if (!run_context.compiler() || !run_context.compiler()->makes_headers()) return {};
  std::map<std::vector<std::string>, std::size_t> programs;
  for (const Task* task : waiting) {
    const std::vector<std::string> roots = task->warm_roots(run_context);
    if (!roots.empty()) ++programs[roots];
  }
  std::vector<SharedHeader> headers;
  for (const auto& [roots, count] : programs) {
    if (count < kFewPrograms || run_context.compiler()->has_header(roots)) continue;
    headers.push_back({roots, count < kManyPrograms ? Warmth::quick : Warmth::thorough, count});
  }
  return headers;
}

}  // namespace mjcourse
