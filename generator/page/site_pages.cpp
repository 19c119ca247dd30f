#include "page/site_pages.h"

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "course/link_target.h"
#include "evaluate/workshop.h"
#include "page/api_page.h"
#include "page/glossary_page.h"
#include "page/json_schema.h"
#include "page/lesson_files.h"
#include "page/long_pages.h"
#include "page/model_page.h"
#include "page/site_paths.h"

namespace mjcourse {

SitePages::SitePages(const Course& course, const Evaluation& evaluation,
                     const std::filesystem::path& root, const Files& assets, SiteFiles& out,
                     bool places)
    : root_(root),
      out_(out),
      files_(root),
      site_{course,
            evaluation,
            files_,
            assets,
            nlohmann::json::parse(assets.read("manifest.json").value()),
            plain_definitions(course, evaluation),
            places},
      parts_(course.lessons.size() + 1) {}

void SitePages::write_lesson(std::size_t index, PressEngines& engines, bool alone) {
  PagePress press(site_, out_, engines);
  mjcourse::write_lesson(site_, index, press, out_, spool_, alone ? nullptr : &parts_[index]);
}

void SitePages::write_others(PressEngines& engines) {
  PagePress press(site_, out_, engines);
  const Course& course = site_.course;
  const Evaluation& evaluation = site_.evaluation;
  if (course.glossary) {
    parts_.back() = verification_parts(course.glossary->page, evaluation.glossary.claims,
                                       press.templates(), spool_);
  }
  write_home(site_, parts_, press, spool_);
  write_verification(site_, parts_, press, out_, spool_);
  if (course.glossary) write_glossary(press);
  if (!evaluation.api.empty()) write_api(press);
  for (const ModelPage& model : evaluation.models) write_model(model, press);
  copy_examples();
  for (const JsonFence& fence : json_fences()) {
    out_.write(schema_path(fence), json_schema(fence).dump(2) + "\n");
  }
}

void SitePages::write_glossary(PagePress& press) {
  const Course& course = site_.course;
  const Lesson& glossary = course.glossary->page;
  const std::string path = page_path(glossary);
  InlineStyles styles;
  const std::string body = glossary_page(course, site_.evaluation, press.press(styles, path),
                                         script_bundle(site_.assets, "collate"));
  copy_images(glossary, site_.evaluation.glossary, out_);
  const Document& summary = glossary.front.summary;
  press.write(path,
              {"glossary", glossary.front.title.text,
               summary ? plain_text(summary.get()) : course.description},
              body, styles);
}

void SitePages::write_api(PagePress& press) {
  InlineStyles styles;
  const std::string body = api_page(site_.course, site_.evaluation, press.press(styles, kApiPage));
  press.write(kApiPage,
              {"api", kApiTitle,
               "What " + site_.course.title + " uses of MuJoCo " +
                   site_.evaluation.versions.mujoco + ", as its headers declare it."},
              body, styles);
}

void SitePages::write_model(const ModelPage& model, PagePress& press) {
  const std::string path = model_page_path(model.name);
  InlineStyles styles;
  const std::string body =
      model_page(model, site_.course, site_.evaluation, press.press(styles, path));
  press.write(path,
              {"model", model.name,
               "The model " + model.name + " of " + site_.course.title +
                   ": a picture, its joints, its MJCF.",
               "../"},
              body, styles);
  out_.write(model_poster_path(model) + ".webp", model.poster.webp);
  out_.write(model_poster_path(model) + ".png", model.poster.png);
  for (const ModelPage::File& file : model.files) out_.copy(root_ / file.path, file.path);
}

void SitePages::copy_examples() {
  std::set<std::string> files;
  for (const Lesson& lesson : site_.course.lessons) {
    for (const Block& block : lesson.blocks) {
      if (const auto* example = std::get_if<Example>(&block)) files.insert(example->file.text);
    }
  }
  for (const std::string& file : files) out_.copy(root_ / file, file);
}

}  // namespace mjcourse
