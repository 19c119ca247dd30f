#include "page/site.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "base/content_hash.h"
#include "course/link_target.h"
#include "evaluate/workshop.h"
#include "page/anchors.h"
#include "page/api_page.h"
#include "page/csv.h"
#include "page/glossary_page.h"
#include "page/inline_styles.h"
#include "page/lesson_pictures.h"
#include "page/model_page.h"
#include "page/page_writer.h"
#include "page/site_directory.h"
#include "page/verification.h"
#include "page/verification_page.h"

namespace mjcourse {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

// `href` leads to the same on the verification page.
json verified_data(const Tally& tally, const std::string& mujoco, const std::string& href) {
  return {{"programs", tally.programs},
          {"snippets", tally.snippets},
          {"outputs", tally.outputs},
          {"values", tally.values},
          {"listed_models", tally.listed_models},
          {"unchecked", tally.unchecked},
          {"answers_proved", tally.answers_proved},
          {"answers_asserted", tally.answers_asserted},
          {"labs", tally.labs},
          {"pictures", tally.pictures},
          {"plots", tally.plots},
          {"formulas", tally.formulas},
          {"mujoco", mujoco},
          {"href", href}};
}

json reference_to(const Lesson& lesson) {
  return {
      {"number", lesson.number}, {"title", lesson.front.title.text}, {"href", page_path(lesson)}};
}

class SiteWriter {
 public:
  SiteWriter(const Course& course, const Evaluation& evaluation, const SitePaths& paths)
      : course_(course),
        evaluation_(evaluation),
        paths_(paths),
        assets_(paths.assets),
        templates_(site_templates(assets_)),
        highlighter_(script_bundle(assets_, "highlight")),
        manifest_(json::parse(assets_.read("manifest.json").value())),
        definitions_(plain_definitions(course, evaluation)),
        directory_(paths.out) {}

  void run() {
    for (std::size_t i = 0; i < course_.lessons.size(); ++i) {
      if (!course_.lessons[i].front.draft) write_lesson(i);
    }
    write_home();
    write_verification();
    if (course_.glossary) write_glossary();
    if (!evaluation_.api.empty()) write_api();
    for (const ModelPage& model : evaluation_.models) write_model(model);
    copy_examples();
    for (const auto& [path, file] : copied_) directory_.copy(file, path);
    for (const fs::directory_entry& entry : fs::directory_iterator(paths_.assets / "public")) {
      directory_.copy(entry.path(), entry.path().filename().string());
    }
    directory_.commit();
  }

 private:
  void write_lesson(std::size_t index);
  void write_pictures(std::size_t index);
  void add_images(const Lesson& page, const LessonResults& results);
  void write_tables(std::size_t index);
  void write_home();
  void write_verification();
  void write_glossary();
  void write_api();
  void write_model(const ModelPage& model);
  Press press(InlineStyles& styles, const std::string& page);
  json pages_data(const std::string& kind) const;
  void copy_examples();
  const Level& level_of(const Lesson& lesson) const;
  std::vector<std::size_t> published(const Level& level) const;
  json levels_data(const Lesson* current) const;
  std::string frame(const std::string& kind, const std::string& title,
                    const std::string& description, const std::string& root, const Lesson* current,
                    const std::string& body, InlineStyles& styles);

  const Course& course_;
  const Evaluation& evaluation_;
  const SitePaths& paths_;
  DiskFiles assets_;
  Templates templates_;
  Highlighter highlighter_;
  json manifest_;
  std::map<std::string, std::string> definitions_;  // of the glossary's terms
  SiteDirectory directory_;
  std::map<std::string, fs::path> copied_;  // at the end, by path: labs may share assets
};

const Level& SiteWriter::level_of(const Lesson& lesson) const {
  return *std::find_if(course_.levels.begin(), course_.levels.end(),
                       [&](const Level& level) { return level.folder == lesson.folder; });
}

// The lessons of a level that the site has: all but the drafts.
std::vector<std::size_t> SiteWriter::published(const Level& level) const {
  std::vector<std::size_t> lessons;
  std::copy_if(level.lessons.begin(), level.lessons.end(), std::back_inserter(lessons),
               [&](std::size_t index) { return !course_.lessons[index].front.draft; });
  return lessons;
}

json SiteWriter::levels_data(const Lesson* current) const {
  json levels = json::array();
  for (const Level& level : course_.levels) {
    json lessons = json::array();
    for (const std::size_t index : published(level)) {
      json lesson = reference_to(course_.lessons[index]);
      lesson["current"] = &course_.lessons[index] == current;
      lessons.push_back(std::move(lesson));
    }
    levels.push_back({{"title", level.title},
                      {"beside", level.number.empty()},
                      {"lessons", std::move(lessons)}});
  }
  return levels;
}

// What the list of lessons offers beside them.
json SiteWriter::pages_data(const std::string& kind) const {
  json pages = json::array();
  if (course_.glossary) {
    const Lesson& glossary = course_.glossary->page;
    pages.push_back({{"title", glossary.front.title.text},
                     {"href", page_path(glossary)},
                     {"current", kind == "glossary"}});
  }
  if (!evaluation_.api.empty()) {
    pages.push_back({{"title", kApiTitle}, {"href", kApiPage}, {"current", kind == "api"}});
  }
  return pages;
}

Press SiteWriter::press(InlineStyles& styles, const std::string& page) {
  return {templates_, highlighter_, manifest_, styles, page, &definitions_};
}

// The page around `body`, which never takes the way through the script engine: the template leaves
// a mark, and the body is put there. What its elements have of styles is written beside the page.
std::string SiteWriter::frame(const std::string& kind, const std::string& title,
                              const std::string& description, const std::string& root,
                              const Lesson* current, const std::string& body,
                              InlineStyles& styles) {
  const std::string styled = styles.take(body);
  std::string sheet;
  if (!styles.sheet().empty()) {
    sheet = "styles/" + content_hash(styles.sheet()) + ".css";
    directory_.write(sheet, styles.sheet());
  }
  const std::string mark =
      "\x02"
      "body\x03";
  std::string html = render_template(
      templates_, "page",
      {{"course",
        {{"title", course_.title},
         {"description", course_.description},
         {"language", course_.language}}},
       {"page",
        {{"title", title}, {"description", description}, {"kind", kind}, {"home", kind == "home"}}},
       {"root", root},
       {"assets",
        {{"css", manifest_.at("site.css")},
         {"js", manifest_.at("site.js")},
         {"favicon", manifest_.at("favicon.svg")}}},
       {"styles", sheet},
       {"levels", levels_data(current)},
       {"pages", pages_data(kind)},
       {"body", mark}});
  return html.replace(html.find(mark), mark.size(), styled);
}

void SiteWriter::write_lesson(std::size_t index) {
  const Lesson& lesson = course_.lessons[index];
  const LessonResults& results = evaluation_.lessons[index];
  InlineStyles styles;
  PageWriter writer(course_, lesson, results, press(styles, page_path(lesson)));
  const std::string mark =
      "\x02"
      "prose\x03";
  const std::string prose = writer.body();
  json objectives = json::array(), prerequisites = json::array();
  for (const Document& objective : lesson.front.objectives) {
    objectives.push_back(writer.inline_html(objective));
  }
  for (const LocatedText& number : lesson.front.prerequisites) {
    prerequisites.push_back(reference_to(*course_.find_lesson(number.text)));
  }
  const Level& level = level_of(lesson);
  // The nearest lesson in one direction that the site has; past an end the index wraps to a huge
  // one. From the course no way leads into what stands beside it, nor back.
  const auto neighbour = [&](std::size_t step) {
    std::size_t at = index + step;
    while (at < course_.lessons.size() && course_.lessons[at].front.draft) at += step;
    const bool there = at < course_.lessons.size() &&
                       level_of(course_.lessons[at]).number.empty() == level.number.empty();
    return there ? reference_to(course_.lessons[at]) : json(nullptr);
  };
  std::string body = render_template(
      templates_, "lesson",
      {{"number", lesson.number},
       {"title", lesson.front.title.text},
       {"summary", writer.inline_html(lesson.front.summary)},
       {"minutes", lesson.front.minutes ? json(*lesson.front.minutes) : json(nullptr)},
       {"objectives", objectives},
       {"prerequisites", prerequisites},
       {"tags", lesson.front.tags},
       {"contents", writer.contents()},
       {"body", mark},
       {"verified",
        verified_data(results.tally, evaluation_.versions.mujoco,
                      "../" + std::string(kVerificationPage) + "#" + lesson_anchor(lesson))},
       {"previous", neighbour(std::size_t(0) - 1)},
       {"next", neighbour(1)},
       {"level", {{"title", level.title}}},
       {"root", "../"}});
  body.replace(body.find(mark), mark.size(), prose);
  const Document& summary = lesson.front.summary;
  const std::string description = summary ? plain_text(summary.get()) : course_.description;
  directory_.write(page_path(lesson), frame("lesson", lesson.number + " " + lesson.front.title.text,
                                            description, "../", &lesson, body, styles));
  write_pictures(index);
  add_images(lesson, results);
  write_tables(index);
  for (const LabFiles& files : writer.lab_files()) {
    for (const auto& [path, bytes] : files.written) directory_.write(path, bytes);
    copied_.insert(files.copied.begin(), files.copied.end());
  }
}

void SiteWriter::write_pictures(std::size_t index) {
  for (const LessonPicture& picture :
       pictures_of(course_.lessons[index], evaluation_.lessons[index])) {
    directory_.write(picture.path + ".webp", picture.poster->webp);
    directory_.write(picture.path + ".png", picture.poster->png);
    if (picture.film != nullptr && !picture.film->empty()) {
      directory_.write(picture.path + ".mp4", *picture.film);
    }
  }
}

void SiteWriter::add_images(const Lesson& page, const LessonResults& results) {
  for (std::size_t i = 0; i < page.blocks.size(); ++i) {
    const auto* image = std::get_if<Image>(&page.blocks[i]);
    const auto* result = results.get<ImageResult>(i);
    if (image == nullptr || result == nullptr) continue;
    copied_[image_path(page, *image, *result)] = result->file;
  }
}

void SiteWriter::write_tables(std::size_t index) {
  const Lesson& lesson = course_.lessons[index];
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* result = evaluation_.lessons[index].get<ChartResult>(i);
    if (result == nullptr) continue;
    directory_.write(table_path(lesson, chart_number(lesson, i)), csv_of(result->table));
  }
}

// A lesson's picture, as its card shows it.
json card_poster(const Lesson& lesson, const LessonResults& results) {
  const std::vector<LessonPicture> pictures = pictures_of(lesson, results);
  const LessonPicture* picture = foremost(pictures);
  if (picture == nullptr) return nullptr;
  return {{"webp", picture->path + ".webp"},
          {"png", picture->path + ".png"},
          {"width", picture->poster->width},
          {"height", picture->poster->height},
          {"alt", ""}};
}

void SiteWriter::write_home() {
  json levels = json::array();
  Tally total;
  InlineStyles styles;
  for (const Level& level : course_.levels) {
    json lessons = json::array();
    for (const std::size_t index : published(level)) {
      const Lesson& lesson = course_.lessons[index];
      const LessonResults& results = evaluation_.lessons[index];
      const PageWriter writer(course_, lesson, results, press(styles, "index.html"));
      total += results.tally;
      json card = reference_to(lesson);
      card["summary"] = writer.inline_html(lesson.front.summary);
      card["minutes"] = lesson.front.minutes ? json(*lesson.front.minutes) : json(nullptr);
      card["poster"] = level.number.empty() ? json(nullptr) : card_poster(lesson, results);
      lessons.push_back(std::move(card));
    }
    levels.push_back({{"folder", level.folder},
                      {"number", level.number},
                      {"title", level.title},
                      {"lessons", std::move(lessons)}});
  }
  total += evaluation_.glossary.tally;
  const std::string body = render_template(
      templates_, "home",
      {{"course", {{"title", course_.title}, {"description", course_.description}}},
       {"root", ""},
       {"levels", levels},
       {"verified", verified_data(total, evaluation_.versions.mujoco, kVerificationPage)}});
  directory_.write("index.html",
                   frame("home", course_.title, course_.description, "", nullptr, body, styles));
}

void SiteWriter::write_verification() {
  const json all = published_verification(course_, evaluation_);
  InlineStyles styles;
  directory_.write(kVerificationJson, json_file(all));
  directory_.write(
      kVerificationPage,
      frame("verification", "What was verified", "What this course states, and how it was checked.",
            "", nullptr,
            render_template(templates_, "verification", verification_data(all, true, {})), styles));
}

void SiteWriter::write_glossary() {
  const Lesson& glossary = course_.glossary->page;
  const std::string path = page_path(glossary);
  InlineStyles styles;
  const std::string body =
      glossary_page(course_, evaluation_, press(styles, path), script_bundle(assets_, "collate"));
  add_images(glossary, evaluation_.glossary);
  const Document& summary = glossary.front.summary;
  directory_.write(path, frame("glossary", glossary.front.title.text,
                               summary ? plain_text(summary.get()) : course_.description, "",
                               nullptr, body, styles));
}

void SiteWriter::write_api() {
  InlineStyles styles;
  const std::string body = api_page(course_, evaluation_, press(styles, kApiPage));
  directory_.write(kApiPage, frame("api", kApiTitle,
                                   "What " + course_.title + " uses of MuJoCo " +
                                       evaluation_.versions.mujoco + ", as its headers declare it.",
                                   "", nullptr, body, styles));
}

void SiteWriter::write_model(const ModelPage& model) {
  const std::string path = model_page_path(model.name);
  InlineStyles styles;
  const std::string body = model_page(model, course_, evaluation_, press(styles, path));
  directory_.write(path, frame("model", model.name,
                               "The model " + model.name + " of " + course_.title +
                                   ": a picture, its joints, its MJCF.",
                               "../", nullptr, body, styles));
  directory_.write(model_poster_path(model) + ".webp", model.poster.webp);
  directory_.write(model_poster_path(model) + ".png", model.poster.png);
  for (const ModelPage::File& file : model.files) copied_[file.path] = paths_.course / file.path;
}

void SiteWriter::copy_examples() {
  std::set<std::string> files;
  for (const Lesson& lesson : course_.lessons) {
    for (const Block& block : lesson.blocks) {
      if (const auto* example = std::get_if<Example>(&block)) files.insert(example->file.text);
    }
  }
  for (const std::string& file : files) directory_.copy(paths_.course / file, file);
}

}  // namespace

void write_site(const Course& course, const Evaluation& evaluation, const SitePaths& paths) {
  SiteWriter(course, evaluation, paths).run();
}

}  // namespace mjcourse
