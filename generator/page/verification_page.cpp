#include "page/verification_page.h"

#include <set>
#include <string_view>
#include <utility>

#include "page/html/site_paths.h"
#include "page/html/verification.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr std::size_t kFewClaims = 8;             // that a list shows without being asked
constexpr std::string_view kCounted = "formula";  // what is not listed where it is proved, and more

struct Titled {
  const char* name;
  const char* title;
};

// The order in which a lesson's claims are shown: what a reader doubts first.
constexpr Titled kKinds[] = {{"answer", "Answers"},
                             {"program", "Programs"},
                             {"page", "Programs in the page"},
                             {"region", "Parts of programs"},
                             {"snippet", "Snippets"},
                             {"commands", "Commands"},
                             {"output", "Outputs"},
                             {"lab", "Labs"},
                             {"picture", "Pictures"},
                             {"plot", "Plots"},
                             {"image", "Pictures of the author's own"},
                             {"listing", "Models in the text"},
                             {"value", "Numbers in the text"},
                             {"formula", "Formulas"},
                             {"citation", "Established facts"},
                             {"code", "Code that nobody ran"}};

constexpr Titled kStatuses[] = {{"proved", "proved"},
                                {"cited", "cited"},
                                {"asserted", "asserted"},
                                {"unchecked", "not run"},
                                {"failed", "failed"}};

const char* title_of(const std::string& status) {
  for (const Titled& known : kStatuses) {
    if (status == known.name) return known.title;
  }
  return "";
}

class PageData {
 public:
  PageData(const json& verification, bool links, const Findings& findings)
      : verification_(verification), links_(links), findings_(findings) {}

  json run() const {
    json lessons = json::array();
    for (const json& lesson : verification_["lessons"]) lessons.push_back(lesson_data(lesson));
    json pictures = json::array();
    for (const ShownPicture& picture : findings_.pictures) {
      pictures.push_back({{"name", picture.name},
                          {"reference", picture.reference},
                          {"actual", picture.actual},
                          {"difference", picture.difference},
                          {"agrees", picture.agrees}});
    }
    return {{"course", verification_["course"]},
            {"versions", verification_["versions"]},
            {"sandbox", verification_.value("sandbox", "")},
            {"json", kVerificationJson},
            {"counts", counts_data(verification_["counts"])},
            {"failed", with_status({"failed"})},
            {"messages", findings_.others},
            {"pictures", std::move(pictures)},
            {"open", with_status({"asserted", "unchecked"})},
            {"lessons", std::move(lessons)},
            {"open_parts", ""},
            {"lesson_parts", ""}};
  }

 private:
  json counts_data(const json& counts) const {
    json shown = json::array();
    for (const Titled& status : kStatuses) {
      if (counts[status.name] == 0) continue;
      shown.push_back(
          {{"status", status.name}, {"title", status.title}, {"count", counts[status.name]}});
    }
    return shown;
  }

  // `shared`: how and limits are said above the list.
  json claim_data(const json& lesson, const json& claim, bool listed, bool shared) const {
    const std::string id = claim["id"];
    const auto messages = findings_.of_claim.find(id);
    const bool told = !listed && messages != findings_.of_claim.end();  // once, where it failed
    const bool linked = links_ && !claim["page"].get_ref<const std::string&>().empty();
    return {{"id", listed ? id : ""},
            {"what", claim["what"]},
            {"code", claim["kind"] == "formula" || claim["kind"] == "value"},
            {"status", claim["status"]},
            {"title", title_of(claim["status"])},
            {"how", shared ? "" : claim["how"]},
            {"limits", shared ? "" : claim["limits"]},
            {"reason", claim["reason"]},
            {"lesson", listed ? "" : "Lesson " + lesson["number"].get<std::string>()},
            {"file", lesson["file"]},
            {"line", claim["line"]},
            {"href", linked ? claim["page"] : json("")},
            {"key", claim["key"]},
            {"messages", told ? messages->second : std::vector<std::string>{}}};
  }

  json with_status(const std::vector<std::string>& statuses) const {
    json found = json::array();
    for (const std::string& status : statuses) {
      for (const json& lesson : verification_["lessons"]) {
        for (const json& claim : lesson["claims"]) {
          if (claim["status"] == status) found.push_back(claim_data(lesson, claim, false, false));
        }
      }
    }
    return found;
  }

  json group_data(const json& lesson, const Titled& kind) const {
    std::vector<const json*> claims;
    for (const json& claim : lesson["claims"]) {
      if (claim["kind"] == kind.name) claims.push_back(&claim);
    }
    std::set<std::pair<std::string, std::string>> ways;
    std::size_t proved = 0;
    for (const json* claim : claims) {
      if ((*claim)["status"] != "proved") continue;
      ways.emplace((*claim)["how"], (*claim)["limits"]);
      ++proved;
    }
    const bool shared = proved > 1 && ways.size() == 1;
    // A lesson of mathematics has hundreds of formulas, of which nobody doubts one by one.
    const bool counted = shared && proved > kFewClaims && std::string_view(kind.name) == kCounted;
    json shown = json::array();
    for (const json* claim : claims) {
      const bool said = shared && (*claim)["status"] == "proved";
      if (!said || !counted) shown.push_back(claim_data(lesson, *claim, true, said));
    }
    return {{"title", kind.title},
            {"count", claims.size()},
            {"open", shown.size() <= kFewClaims},
            {"how", shared ? ways.begin()->first : ""},
            {"limits", shared ? ways.begin()->second : ""},
            {"counted", counted ? proved : 0},
            {"json", kVerificationJson},
            {"claims", std::move(shown)}};
  }

  json lesson_data(const json& lesson) const {
    json groups = json::array();
    for (const Titled& kind : kKinds) {
      json group = group_data(lesson, kind);
      if (group["count"] != 0) groups.push_back(std::move(group));
    }
    return {{"id", lesson["id"]},
            {"number", lesson["number"]},
            {"title", lesson["title"]},
            {"href", links_ ? lesson["page"] : json("")},
            {"counts", counts_data(lesson["counts"])},
            {"groups", std::move(groups)}};
  }

  const json& verification_;
  bool links_;
  const Findings& findings_;
};

}  // namespace

json verification_data(const json& verification, bool links, const Findings& findings) {
  return PageData(verification, links, findings).run();
}

}  // namespace mjcourse
