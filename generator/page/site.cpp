#include "page/site.h"

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "base/content_hash.h"
#include "course/link_target.h"
#include "evaluate/workshop.h"
#include "page/api_page.h"
#include "page/course_data.h"
#include "page/csv.h"
#include "page/glossary_page.h"
#include "page/home_page.h"
#include "page/inline_styles.h"
#include "page/lesson_page.h"
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
  void copy_examples();
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
       {"levels", levels_data(course_, current)},
       {"pages", pages_data(course_, evaluation_, kind)},
       {"body", mark}});
  return html.replace(html.find(mark), mark.size(), styled);
}

void SiteWriter::write_lesson(std::size_t index) {
  const Lesson& lesson = course_.lessons[index];
  const LessonResults& results = evaluation_.lessons[index];
  InlineStyles styles;
  PageWriter writer(course_, lesson, results, press(styles, page_path(lesson)));
  const std::string body = lesson_page(course_, evaluation_, index, writer, templates_);
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

void SiteWriter::write_home() {
  InlineStyles styles;
  const std::string body = home_page(course_, evaluation_, press(styles, "index.html"));
  directory_.write("index.html",
                   frame("home", course_.title, course_.description, "", nullptr, body, styles));
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
    directory_.write(block_path(lesson, i) + ".csv", csv_of(result->table));
  }
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
