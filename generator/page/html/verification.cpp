#include "page/html/verification.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "page/html/anchors.h"
#include "page/html/site_paths.h"
#include "report/diagnostic_json.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr int kFormat = 1;  // of the JSON; counts up when its readers must change

json no_counts() {
  return {{"proved", 0}, {"cited", 0}, {"asserted", 0}, {"unchecked", 0}, {"failed", 0}};
}

void count(json& counts, const Claims& claims) {
  add_counts(counts, counts_of(claims));
}

// Where a reader of the site finds it; "" in a draft.
std::string link_to(const Lesson& lesson, const Claim& claim) {
  if (lesson.front.draft) return "";
  const std::string anchor = place_anchor(lesson, claim);
  return site_address(page_path(lesson)) + (anchor.empty() ? "" : "#" + anchor);
}

json claim_json(const Lesson& lesson, const Claims& claims, std::size_t index) {
  const Claim& claim = claims[index];
  return {{"id", claim_anchor(lesson, index)},
          {"kind", name_of(claim.kind)},
          {"status", name_of(claim.status)},
          {"what", claim.what},
          {"how", claim.how},
          {"limits", claim.limits},
          {"reason", claim.reason},
          {"line", claim.place.line},
          {"column", claim.place.column},
          {"page", link_to(lesson, claim)},
          {"key", claim.key}};
}

}  // namespace

json verification_of(const Lesson& lesson, const Claims& claims) {
  json all = json::array();
  for (std::size_t i = 0; i < claims.size(); ++i) all.push_back(claim_json(lesson, claims, i));
  json counts = no_counts();
  count(counts, claims);
  const std::string& title = lesson.front.title.text;
  return {{"id", lesson_anchor(lesson)},
          {"number", lesson.number},
          {"title", title.empty() ? lesson.slug : title},
          {"file", lesson.source->path()},
          {"page", lesson.front.draft ? "" : site_address(page_path(lesson))},
          {"counts", std::move(counts)},
          {"claims", std::move(all)}};
}

json verification_of_none(const std::string& course, const Versions& versions) {
  return {{"format", kFormat},
          {"course", course},
          {"versions",
           {{"mjcourse", versions.mjcourse},
            {"mujoco", versions.mujoco},
            {"compiler", versions.compiler},
            {"katex", versions.katex},
            {"engine", versions.engine}}},
          {"counts", no_counts()},
          {"lessons", json::array()}};
}

StatusCounts counts_of(const Claims& claims) {
  StatusCounts counts{};
  for (const Claim& claim : claims) ++counts.at(static_cast<std::size_t>(claim.status));
  return counts;
}

void add_counts(json& counts, const StatusCounts& more) {
  for (std::size_t i = 0; i < more.size(); ++i) {
    json& of_status = counts[name_of(static_cast<Claim::Status>(i))];
    of_status = of_status.get<int>() + more.at(i);
  }
}

namespace {

// Milliseconds are more than enough of what no two runs share.
double rounded(double seconds) {
  return std::round(1000 * seconds) / 1000;
}

// Every lesson, drafts too, with the times that were measured.
void add_lessons(const Course& course, const Evaluation& evaluation, json& all) {
  for (const Lesson* page : course.pages()) {
    const Claims& claims = evaluation.results_of(*page).claims;
    json& lesson = all["lessons"].emplace_back(verification_of(*page, claims));
    for (std::size_t c = 0; c < claims.size(); ++c) {
      lesson["claims"][c]["seconds"] = rounded(claims[c].seconds);
      lesson["claims"][c]["run_seconds"] = rounded(claims[c].run_seconds);
    }
    lesson["draft"] = page->front.draft;
    count(all["counts"], claims);
  }
}

}  // namespace

json published_verification(const Course& course, const Evaluation& evaluation) {
  json all = verification_of_none(course.title, evaluation.versions);
  for (const Lesson* page : course.pages()) {
    if (page->front.draft) continue;
    const Claims& claims = evaluation.results_of(*page).claims;
    all["lessons"].push_back(verification_of(*page, claims));
    count(all["counts"], claims);
  }
  return all;
}

json full_verification(const Course* course, const Evaluation& evaluation, double seconds) {
  json all = verification_of_none(course != nullptr ? course->title : "", evaluation.versions);
  if (course != nullptr) add_lessons(*course, evaluation, all);
  const Diagnostics& found = evaluation.diagnostics;
  all["succeeded"] = std::none_of(found.begin(), found.end(), [](const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::error;
  });
  all["seconds"] = rounded(seconds);
  all["sandbox"] = evaluation.sandbox;
  all["diagnostics"] = json::array();
  for (const Diagnostic& diagnostic : found) all["diagnostics"].push_back(json_of(diagnostic));
  return all;
}

std::string json_text(const json& json) {
  return json.dump(1, ' ', false, json::error_handler_t::replace);
}

std::string indented(const std::string& text, std::size_t columns) {
  const std::string blanks(columns, ' ');
  std::string moved = blanks;
  for (const char c : text) {
    moved += c;
    if (c == '\n') moved += blanks;
  }
  return moved;
}

std::string json_file(const json& json) {
  return json_text(json) + "\n";
}

}  // namespace mjcourse
