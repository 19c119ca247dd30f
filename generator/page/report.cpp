#include "page/report.h"

#include <algorithm>
#include <utility>

#include "page/anchors.h"
#include "page/page_writer.h"
#include "page/site_directory.h"
#include "page/verification.h"
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

// Each message goes to the claims that it is about, of those that are not proved.
Findings findings_of(const Run& run) {
  Findings findings;
  const std::size_t lessons = run.course != nullptr ? run.course->lessons.size() : 0;
  for (const Diagnostic& diagnostic : run.evaluation.diagnostics) {
    const std::string text = format_for_terminal(diagnostic);
    bool shown = false;
    for (std::size_t l = 0; l < lessons; ++l) {
      const Lesson& lesson = run.course->lessons[l];
      const Claims& claims = run.evaluation.lessons[l].claims;
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

// The pictures' files; gives where the page finds them.
std::vector<ShownPicture> write_pictures(const std::vector<ComparedPicture>& pictures,
                                         SiteDirectory& directory) {
  std::vector<ShownPicture> shown;
  for (const ComparedPicture& picture : pictures) {
    const std::string path = "pictures/" + picture.name;
    directory.write(path + "-reference.png", picture.reference);
    directory.write(path + "-actual.png", picture.actual);
    directory.write(path + "-difference.png", picture.difference);
    shown.push_back({picture.name, path + "-reference.png", path + "-actual.png",
                     path + "-difference.png", picture.agrees});
  }
  return shown;
}

}  // namespace

void write_report(const Run& run, const fs::path& assets, const fs::path& out) {
  const DiskFiles files(assets);
  Templates templates = site_templates(files);
  const json manifest = json::parse(files.read("manifest.json").value());
  SiteDirectory directory(out);
  // The stylesheet, what it names, and nothing that runs.
  for (const auto& [name, path] : manifest.items()) {
    const std::string file = path;
    if (file.ends_with(".css") || file.ends_with(".woff2") || file.ends_with(".svg")) {
      directory.copy(assets / "public" / file, file);
    }
  }
  Findings findings = findings_of(run);
  findings.pictures = write_pictures(run.pictures, directory);
  const json all = full_verification(run.course, run.evaluation, run.seconds);
  directory.write(kVerificationJson, json_file(all));
  json data = verification_data(all, false, findings);
  data["language"] = run.course != nullptr ? run.course->language : "en";
  data["assets"] = {{"css", manifest.at("site.css")}, {"favicon", manifest.at("favicon.svg")}};
  directory.write("index.html", render_template(templates, "report", data));
  directory.commit();
}

}  // namespace mjcourse
