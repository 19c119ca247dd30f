#include "page/report.h"

#include <algorithm>
#include <utility>

#include "course/language.h"
#include "findings/lesson_results.h"
#include "page/blocks/page_writer.h"
#include "page/html/anchors.h"
#include "page/html/site_paths.h"
#include "page/html/verification.h"
#include "page/site_directory.h"
#include "page/verification_page.h"
#include "report/terminal.h"

namespace mjcourse {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

bool is_in(const Place& place, const Lesson& lesson, const Claim& claim) {
  const Position begin = lesson.source->position(claim.extent.begin);
  const Position end = lesson.source->position(claim.extent.end);
  const std::pair at(place.line, place.column);
  return place.file == lesson.source->path() && at >= std::pair(begin.line, begin.column) &&
         at <= std::pair(end.line, end.column);
}

// Does `diagnostic` stand in `claim`, or say in a note that this has a part in it?
bool concerns(const Diagnostic& diagnostic, const Lesson& lesson, const Claim& claim) {
  return is_in(diagnostic.place, lesson, claim) ||
         std::any_of(diagnostic.notes.begin(), diagnostic.notes.end(),
                     [&](const Note& note) { return is_in(note.place, lesson, claim); });
}

std::vector<const Lesson*> pages_of(const Run& run) {
  return run.course != nullptr ? run.course->pages() : std::vector<const Lesson*>();
}

// Each message goes to the claims that it is about, of those that are not proved.
Findings findings_of(const Run& run) {
  Findings findings;
  for (const Diagnostic& diagnostic : run.evaluation.diagnostics) {
    const std::string text = format_for_terminal(diagnostic);
    bool shown = false;
    for (const Lesson* page : pages_of(run)) {
      const Lesson& lesson = *page;
      const Claims& claims = run.evaluation.results_of(lesson).claims;
      for (std::size_t c = 0; c < claims.size(); ++c) {
        const Claim::Status status = claims[c].status;
        if (status == Claim::Status::proved || status == Claim::Status::cited) continue;
        if (!concerns(diagnostic, lesson, claims[c])) continue;
        findings.of_claim[claim_anchor(lesson, c)].push_back(text);
        shown = true;
      }
    }
    if (!shown) findings.others.push_back(text);
  }
  return findings;
}

// The files of what is pinned; gives where the page finds them.
std::vector<ShownPicture> write_pictures(const Run& run, SiteFiles& directory) {
  std::vector<ShownPicture> shown;
  for (const Lesson* page : pages_of(run)) {
    for (const PinComparison* pin : pins_of(run.evaluation.results_of(*page))) {
      const std::string name = page->number + "-" + pin->name;
      const auto write = [&](const std::string& which, const Blob& bytes) -> std::string {
        if (bytes.empty()) return "";
        std::string path = "pictures/" + name + "-" + which + ".png";
        directory.write(path, bytes.bytes());
        return path;
      };
      shown.push_back({name, write("reference", pin->reference), write("actual", pin->actual),
                       write("difference", pin->difference), pin->agrees});
    }
  }
  return shown;
}

}  // namespace

void write_report(const Run& run, const fs::path& assets, const fs::path& out,
                  const fs::path& course) {
  const DiskFiles files(assets);
  Templates templates = site_templates(files);
  const json manifest = json::parse(files.read("manifest.json").value());
  SiteDirectory directory(out, course);
  // The stylesheet, what it names, and nothing that runs.
  for (const auto& [name, path] : manifest.items()) {
    const std::string file = path;
    if (file.ends_with(".css") || file.ends_with(".woff2") || file.ends_with(".svg")) {
      directory.copy_own(assets / "public" / file, file);
    }
  }
  Findings findings = findings_of(run);
  findings.pictures = write_pictures(run, directory);
  const json all = full_verification(run.course, run.evaluation, run.seconds);
  directory.write(kVerificationJson, json_file(all));
  json data = verification_data(all, false, findings);
  data["language"] = run.course != nullptr ? run.course->language : "en";
  data["right_to_left"] = is_right_to_left(data["language"]);
  data["assets"] = {{"css", manifest.at("site.css")}, {"favicon", manifest.at("favicon.svg")}};
  directory.write("index.html", render_template(templates, "report", data));
  directory.commit();
}

}  // namespace mjcourse
