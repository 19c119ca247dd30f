#include "page/site.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "base/content_hash.h"
#include "evaluate/workshop.h"
#include "page/csv.h"
#include "page/inline_styles.h"
#include "page/page_writer.h"
#include "page/site_directory.h"

namespace mjcourse {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::map<std::string, std::string> read_templates(const DiskFiles& assets) {
  std::map<std::string, std::string> sources;
  for (const std::string& name : assets.list("templates")) {
    if (!name.ends_with(".hbs")) continue;
    sources[name.substr(0, name.size() - 4)] = assets.read("templates/" + name).value();
  }
  return sources;
}

json verified_data(const Tally& tally, const std::string& mujoco) {
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
          {"mujoco", mujoco}};
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
        templates_(script_bundle(assets_, "templates"), read_templates(assets_)),
        highlighter_(script_bundle(assets_, "highlight")),
        manifest_(json::parse(assets_.read("manifest.json").value())),
        directory_(paths.out) {}

  void run() {
    for (std::size_t i = 0; i < course_.lessons.size(); ++i) {
      if (!course_.lessons[i].front.draft) write_lesson(i);
    }
    write_home();
    copy_examples();
    for (const auto& [path, file] : copied_) directory_.copy(file, path);
    for (const fs::directory_entry& entry : fs::directory_iterator(paths_.assets / "public")) {
      directory_.copy(entry.path(), entry.path().filename().string());
    }
    directory_.commit();
  }

 private:
  void write_lesson(std::size_t index);
  void write_posters(std::size_t index);
  void write_tables(std::size_t index);
  void write_home();
  void copy_examples();
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
  SiteDirectory directory_;
  std::map<std::string, fs::path> copied_;  // the labs' assets, which they may share, by path
};

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
    levels.push_back({{"title", level.title}, {"lessons", std::move(lessons)}});
  }
  return levels;
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
  std::string html =
      render_template(templates_, "page",
                      {{"course",
                        {{"title", course_.title},
                         {"description", course_.description},
                         {"language", course_.language}}},
                       {"page", {{"title", title}, {"description", description}, {"kind", kind}}},
                       {"root", root},
                       {"assets",
                        {{"css", manifest_.at("site.css")},
                         {"js", manifest_.at("site.js")},
                         {"favicon", manifest_.at("favicon.svg")}}},
                       {"styles", sheet},
                       {"levels", levels_data(current)},
                       {"body", mark}});
  return html.replace(html.find(mark), mark.size(), styled);
}

void SiteWriter::write_lesson(std::size_t index) {
  const Lesson& lesson = course_.lessons[index];
  const LessonResults& results = evaluation_.lessons[index];
  InlineStyles styles;
  PageWriter writer(course_, lesson, results, {templates_, highlighter_, manifest_, styles});
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
  // The nearest lesson in one direction that the site has; past an end the index wraps to a huge
  // one.
  const auto neighbour = [&](std::size_t step) {
    std::size_t at = index + step;
    while (at < course_.lessons.size() && course_.lessons[at].front.draft) at += step;
    return at < course_.lessons.size() ? reference_to(course_.lessons[at]) : json(nullptr);
  };
  std::string level_title;
  for (const Level& level : course_.levels) {
    if (level.folder == lesson.folder) level_title = level.title;
  }
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
       {"verified", verified_data(results.tally, evaluation_.mujoco)},
       {"previous", neighbour(std::size_t(0) - 1)},
       {"next", neighbour(1)},
       {"level", {{"title", level_title}}},
       {"root", "../"}});
  body.replace(body.find(mark), mark.size(), prose);
  const Document& summary = lesson.front.summary;
  const std::string description = summary ? plain_text(summary.get()) : course_.description;
  directory_.write(page_path(lesson), frame("lesson", lesson.number + " " + lesson.front.title.text,
                                            description, "../", &lesson, body, styles));
  write_posters(index);
  write_tables(index);
  for (const LabFiles& files : writer.lab_files()) {
    for (const auto& [path, bytes] : files.written) directory_.write(path, bytes);
    copied_.insert(files.copied.begin(), files.copied.end());
  }
}

void SiteWriter::write_posters(std::size_t index) {
  const Lesson& lesson = course_.lessons[index];
  int lab = 0;
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    if (!std::holds_alternative<Lab>(lesson.blocks[i])) continue;
    ++lab;
    const auto* result = evaluation_.lessons[index].get<LabResult>(i);
    if (result == nullptr || !result->poster) continue;
    directory_.write(poster_path(lesson, lab) + ".webp", result->poster->webp);
    directory_.write(poster_path(lesson, lab) + ".png", result->poster->png);
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

// The first poster of a lesson, as its card shows it.
json card_poster(const Lesson& lesson, const LessonResults& results) {
  int lab = 0;
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    if (!std::holds_alternative<Lab>(lesson.blocks[i])) continue;
    ++lab;
    const auto* result = results.get<LabResult>(i);
    if (result == nullptr || !result->poster) continue;
    const std::string path = poster_path(lesson, lab);
    return {{"webp", path + ".webp"},
            {"png", path + ".png"},
            {"width", result->poster->width},
            {"height", result->poster->height},
            {"alt", ""}};
  }
  return nullptr;
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
      const PageWriter writer(course_, lesson, results,
                              {templates_, highlighter_, manifest_, styles});
      total += results.tally;
      json card = reference_to(lesson);
      card["summary"] = writer.inline_html(lesson.front.summary);
      card["minutes"] = lesson.front.minutes ? json(*lesson.front.minutes) : json(nullptr);
      card["poster"] = card_poster(lesson, results);
      lessons.push_back(std::move(card));
    }
    levels.push_back({{"number", level.folder.substr(0, level.folder.find('-'))},
                      {"title", level.title},
                      {"lessons", std::move(lessons)}});
  }
  const std::string body =
      render_template(templates_, "home",
                      {{"course", {{"title", course_.title}, {"description", course_.description}}},
                       {"root", ""},
                       {"levels", levels},
                       {"verified", verified_data(total, evaluation_.mujoco)}});
  directory_.write("index.html",
                   frame("home", course_.title, course_.description, "", nullptr, body, styles));
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
