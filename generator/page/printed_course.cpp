#include "page/printed_course.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/content_hash.h"
#include "course/link_target.h"
#include "page/course_data.h"
#include "page/html/anchors.h"
#include "page/html/moved_html.h"
#include "page/html/placeholder.h"
#include "page/html/site_paths.h"
#include "page/lesson_history.h"
#include "page/site_data.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr const char* kGlossaryAnchor = "glossary";

// Where the page at `address` stands in the document; "" where it is none of it.
std::string anchor_of(const Course& course, const std::string& address) {
  if (course.glossary && address == page_path(course.glossary->page)) return kGlossaryAnchor;
  const std::size_t name = address.rfind('/') + 1;
  const Lesson* lesson = course.find_lesson(address.substr(name, address.find('-', name) - name));
  const bool there =
      lesson != nullptr && !lesson->front.draft && site_address(page_path(*lesson)) == address;
  return there ? lesson_anchor(*lesson) : "";
}

// The move of a piece of the page at `from` into the document, where it begins at `anchor`.
HtmlMove into_document(const Course& course, const std::string& from, const std::string& anchor) {
  HtmlMove move{anchor + "-"};
  move.deeper = true;
  move.still = true;
  move.address = [&course, from, anchor](std::string_view address) {
    if (address.starts_with('#')) return "#" + anchor + "-" + std::string(address.substr(1));
    if (address.find(':') != std::string_view::npos) return std::string(address);
    // A page lies in the root or one folder below it, and so does what it speaks of.
    const bool up = address.starts_with("../");
    const std::string folder = up ? "" : from.substr(0, from.rfind('/') + 1);
    std::string whole = folder + std::string(address.substr(up ? 3 : 0));
    const std::size_t hash = std::min(whole.find('#'), whole.size());
    const std::string target = anchor_of(course, whole.substr(0, hash));
    if (target.empty()) return whole;
    return "#" + target + (hash < whole.size() ? "-" + whole.substr(hash + 1) : "");
  };
  return move;
}

// A text between quotes in CSS.
std::string css_string(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

// Each lesson's pages bear its name at their head.
std::string running_heads(const json& levels) {
  std::string sheet;
  for (const json& level : levels) {
    for (const json& lesson : level["lessons"]) {
      const auto anchor = lesson["anchor"].get<std::string>();
      const std::string name =
          lesson["number"].get<std::string>() + "\u2002" + lesson["title"].get<std::string>();
      sheet += "#" + anchor + "{page:" + anchor + "}\n@page " + anchor +
               "{@top-right{content:" + css_string(name) + "}}\n";
    }
  }
  return sheet;
}

// The day on which any of the lessons was changed last, in words; "" where nobody knows.
std::string newest_day(const SiteData& site) {
  const LastChange* newest = nullptr;
  for (const Lesson& lesson : site.course.lessons) {
    const LastChange* change = lesson.front.draft ? nullptr : last_change(site, lesson);
    if (change != nullptr && (newest == nullptr || newest->time < change->time)) newest = change;
  }
  return newest == nullptr ? "" : day_in_words(newest->day);
}

json levels_of(const Course& course) {
  json levels = json::array();
  for (const Level& level : course.levels) {
    json lessons = json::array();
    for (const std::size_t index : published(course, level)) {
      json lesson = reference_to(course.lessons[index]);
      lesson["anchor"] = lesson_anchor(course.lessons[index]);
      lessons.push_back(std::move(lesson));
    }
    if (!lessons.empty()) {
      levels.push_back(
          {{"number", level.number}, {"title", level.title}, {"lessons", std::move(lessons)}});
    }
  }
  return levels;
}

}  // namespace

PrintedLength::PrintedLength(const Course& course) {
  for (const Lesson& lesson : course.lessons) {
    if (lesson.front.draft) continue;
    bytes_ += lesson.kept == Lesson::Kept::outline ? lesson.length : lesson.source->text().size();
  }
  if (fits()) bytes_ = 0;
}

void add_printed_parts(const SiteData& site, const Lesson& lesson, const LessonPage& page,
                       const PageWriter& writer, Templates& templates, Spool& spool,
                       LessonParts& parts) {
  const std::string anchor = lesson_anchor(lesson);
  const HtmlMove move = into_document(site.course, site_address(page_path(lesson)), anchor);
  json objectives = json::array();
  for (const Document& objective : lesson.front.objectives) {
    objectives.push_back(moved_html(writer.inline_html(objective), move));
  }
  std::string html =
      render_template(templates, "printed-lesson",
                      {{"anchor", anchor},
                       {"number", lesson.number},
                       {"title", lesson.front.title.text},
                       {"level", level_of(site.course, lesson).title},
                       {"summary", moved_html(writer.inline_html(lesson.front.summary), move)},
                       {"objectives", std::move(objectives)},
                       {"body", placeholder("prose")}});
  fill_in(html, "printed-lesson", "body", "prose", moved_html(page.prose, move));
  parts.printed = spool.put(html);
  if (page.answers.empty()) return;
  parts.printed_answers = spool.put(render_template(templates, "printed-answers",
                                                    {{"anchor", anchor},
                                                     {"number", lesson.number},
                                                     {"title", lesson.front.title.text},
                                                     {"answers", moved_html(page.answers, move)}}));
}

void write_printed_course(const SiteData& site, const std::vector<LessonParts>& parts,
                          const std::string& glossary, PageRenderer& renderer, Spool& spool,
                          SiteFiles& directory) {
  const Course& course = site.course;
  PagePart text{placeholder("text"), {}}, terms{placeholder("terms"), {}},
      answers{placeholder("answers"), {}};
  for (const Level& level : course.levels) {
    for (const std::size_t index : published(course, level)) {
      text.pieces.push_back(parts[index].printed);
      if (parts[index].printed_answers.size > 0) {
        answers.pieces.push_back(parts[index].printed_answers);
      }
    }
  }
  if (course.glossary) {
    const HtmlMove move = into_document(course, page_path(course.glossary->page), kGlossaryAnchor);
    terms.pieces.push_back(spool.put(moved_html(glossary, move)));
  }
  const json levels = levels_of(course);
  const std::string heads = running_heads(levels);
  const std::string sheet = "styles/print-" + content_hash(heads) + ".css";
  directory.write(sheet, heads);
  const std::string body =
      render_template(renderer.templates(), "print",
                      {{"title", course.title},
                       {"description", course.description},
                       {"address", course.url},
                       {"day", newest_day(site)},
                       {"mujoco", site.evaluation.versions.mujoco},
                       {"sheet", sheet},
                       {"levels", levels},
                       {"glossary", course.glossary ? course.glossary->page.front.title.text : ""},
                       {"text", text.mark},
                       {"terms", terms.mark},
                       {"answers", answers.pieces.empty() ? "" : answers.mark}});
  renderer.write_long(
      kPrintPage,
      {"print", "To print", "All of " + course.title + " as one document, to print or to keep."},
      body, {text, terms, answers}, spool);
}

}  // namespace mjcourse
