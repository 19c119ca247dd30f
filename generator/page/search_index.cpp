#include "page/search_index.h"

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>

#include "base/content_hash.h"
#include "base/running_text.h"
#include "course/link_target.h"
#include "page/html/search_text.h"
#include "page/html/site_paths.h"
#include "page/site_data.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr const char* kIndexHead = "mjcourse.pages = [\n";

json section_json(const SearchSection& section) {
  return {{"title", section.title},
          {"anchor", section.anchor},
          {"text", section.text},
          {"code", section.code}};
}

json page_json(const std::string& kind, const std::string& title, const std::string& href) {
  return {{"kind", kind},
          {"number", ""},
          {"title", title},
          {"href", href},
          {"sections", json::array()}};
}

json glossary_json(const SiteData& site) {
  const Glossary& glossary = *site.course.glossary;
  json page =
      page_json("glossary", glossary.page.front.title.text, site_address(page_path(glossary.page)));
  for (const Glossary::Term& term : glossary.terms) {
    page["sections"].push_back(
        section_json({term.name, term.id, site.definitions.at(term.key), {}}));
  }
  return page;
}

json api_json(const Evaluation& evaluation) {
  json page = page_json("api", kApiTitle, kApiPage);
  for (const ApiEntry& entry : evaluation.api) {
    page["sections"].push_back(section_json({entry.name, api_id(entry.name),
                                             with_single_blanks(entry.kind + ". " + entry.comment),
                                             with_single_blanks(entry.declaration)}));
  }
  return page;
}

json model_json(const ModelPage& model, std::size_t most) {
  SearchSection section;
  const auto list = [&](const char* what, const auto& things) {
    if (!things.empty()) section.text += what;
    for (const auto& thing : things) section.text += " " + thing.name;
    if (!things.empty()) section.text += ". ";
  };
  list("Joints:", model.joints);
  list("Actuators:", model.actuators);
  list("Sensors:", model.sensors);
  list("Keyframes:", model.keyframes);
  section.text = beginning_of(with_single_blanks(section.text), most);
  for (const ModelPage::File& file : model.files) section.code += file.text + " ";
  section.code = beginning_of(with_single_blanks(section.code), most);
  json page = page_json("model", model.name, site_address(model_page_path(model.name)));
  page["sections"].push_back(section_json(section));
  return page;
}

// The pages that no lesson is. A model's may say as much as a lesson's.
std::vector<std::string> other_pages(const SiteData& site, std::size_t most) {
  std::vector<std::string> pages;
  if (site.course.glossary) pages.push_back(glossary_json(site).dump());
  if (!site.evaluation.api.empty()) pages.push_back(api_json(site.evaluation).dump());
  for (const ModelPage& model : site.evaluation.models) {
    pages.push_back(model_json(model, most).dump());
  }
  return pages;
}

}  // namespace

std::size_t search_share(const Course& course) {
  return kMostSearchText / std::max<std::size_t>(course.lessons.size(), 1);
}

void add_search_part(const Lesson& lesson, const LessonResults& results, std::size_t most,
                     Spool& spool, LessonParts& parts) {
  json page = page_json("lesson", lesson.front.title.text, site_address(page_path(lesson)));
  page["number"] = lesson.number;
  const std::vector<SearchSection> sections = search_sections(lesson, results);
  for (SearchSection section : sections) {
    section.text = beginning_of(section.text, most / sections.size());
    section.code = beginning_of(section.code, most / sections.size() - section.text.size());
    page["sections"].push_back(section_json(section));
  }
  const std::string text = page.dump();
  parts.search = spool.put(text);
  parts.search_hash = content_hash(text);
}

void write_search_index(const SiteData& site, const std::vector<LessonParts>& parts,
                        const Spool& spool, SiteFiles& directory) {
  const std::vector<std::string> others = other_pages(site, search_share(site.course));
  const std::vector<Lesson>& lessons = site.course.lessons;
  std::string hashes = kIndexHead;
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    if (!lessons[i].front.draft) hashes += parts[i].search_hash;
  }
  for (const std::string& page : others) hashes += content_hash(page);
  const std::string path = "search-" + content_hash(hashes) + ".js";
  directory.write(path, [&](std::ostream& file) {
    file << kIndexHead;
    for (std::size_t i = 0; i < lessons.size(); ++i) {
      if (!lessons[i].front.draft) file << spool.get(parts[i].search) << ",\n";
    }
    for (const std::string& page : others) file << page << ",\n";
    file << "];\n";
  });
  const json names{{"code", site.manifest.at("search.js")},
                   {"styles", site.manifest.at("search.css")},
                   {"index", path}};
  directory.write(kSearchScript, "window.mjcourse = " + names.dump() + ";\n");
}

}  // namespace mjcourse
