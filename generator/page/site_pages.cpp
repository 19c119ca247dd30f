#include "page/site_pages.h"

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "base/content_hash.h"
#include "course/link_target.h"
#include "findings/snippet_program.h"
#include "lesson/json/json_fences.h"
#include "lesson/syntax/exercise_text.h"
#include "page/api_page.h"
#include "page/blocks/program_data.h"
#include "page/blocks/themed_assets.h"
#include "page/gallery_page.h"
#include "page/glossary_page.h"
#include "page/html/site_paths.h"
#include "page/json_schema.h"
#include "page/learner_pages.h"
#include "page/lesson_files.h"
#include "page/long_pages.h"
#include "page/model_page.h"
#include "page/moved_pages.h"
#include "page/printed_course.h"
#include "page/program_folder.h"
#include "page/search_index.h"
#include "page/site_data.h"
#include "page/web_files.h"
#include "page/zip.h"
#include "script/script_bundles.h"

namespace mjcourse {
namespace {

// Gives where the course's own stylesheet lies in the site; "" for none.
std::string write_theme(const Files& course, SiteFiles& out) {
  const auto style = course.read(kThemeStyle);
  if (!style) return "";
  std::string path = "assets/theme-" + content_hash(*style) + ".css";
  out.write(path, *style);
  return path;
}

}  // namespace

SitePages::SitePages(const Course& course, const Evaluation& evaluation,
                     const std::filesystem::path& root, const Files& assets, SiteFiles& out,
                     bool places, LastChanges changes, OutlineClaims claims_of_outline)
    : root_(root),
      out_(out),
      files_(root),
      site_{course,
            evaluation,
            files_,
            assets,
            nlohmann::json::parse(assets.read("manifest.json").value()),
            plain_definitions(course, evaluation),
            places,
            write_theme(files_, out),
            std::move(changes)},
      parts_(course.lessons.size() + 1),
      printed_(course) {
  site_.claims_of_outline = std::move(claims_of_outline);
  site_.feed = has_feed(site_);
  site_.compiler_bytes = compiler_bytes(assets, site_.manifest);
}

void SitePages::write_lesson(std::size_t index, PageEngines& engines, bool alone) {
  PageRenderer renderer(site_, out_, engines);
  mjcourse::write_lesson(site_, index, renderer, out_, spool_, printed_,
                         alone ? nullptr : &parts_[index]);
}

void SitePages::write_others(PageEngines& engines) {
  PageRenderer renderer(site_, out_, engines);
  const Course& course = site_.course;
  const Evaluation& evaluation = site_.evaluation;
  site_.prints = printed_.fits();
  if (course.glossary) {
    parts_.back() = verification_parts(course.glossary->page, evaluation.glossary.claims,
                                       renderer.templates(), spool_);
  }
  write_home(site_, parts_, renderer, spool_);
  write_verification(site_, parts_, renderer, out_, spool_);
  write_progress(site_, parts_, renderer, spool_);
  write_kept(site_, renderer);
  if (site_.asks) write_review(site_, parts_, renderer, out_, spool_);
  const std::string glossary = course.glossary ? write_glossary(renderer) : "";
  if (site_.prints) write_printed_course(site_, parts_, glossary, renderer, spool_, out_);
  if (!evaluation.api.empty()) write_api(renderer);
  for (const ModelPage& model : evaluation.models) write_model(model, renderer);
  if (!evaluation.models.empty()) write_gallery(renderer);
  write_missing(renderer);
  write_search(renderer);
  write_search_index(site_, parts_, spool_, out_);
  copy_examples();
  write_moved_pages(site_, renderer.templates(), out_);
  write_web_files(site_, parts_, renderer.templates(), out_, spool_);
  const PlotGrammar grammar = read_plot_grammar(site_.assets);
  for (const JsonFence& fence : json_fences()) {
    out_.write(schema_path(fence), json_schema(fence, grammar).dump(2) + "\n");
  }
}

std::string SitePages::write_glossary(PageRenderer& renderer) {
  const Course& course = site_.course;
  const Lesson& glossary = course.glossary->page;
  const std::string path = page_path(glossary);
  InlineStyles styles;
  std::string body = glossary_page(course, site_.evaluation, renderer.context(styles, path),
                                   script_bundle(site_.assets, "collate"));
  copy_images(glossary, site_.evaluation.glossary, out_);
  const Document& summary = glossary.front.summary;
  renderer.write(path,
                 {"glossary", glossary.front.title.text,
                  summary ? plain_text(summary.get()) : course.description},
                 body, styles);
  return body;
}

void SitePages::write_api(PageRenderer& renderer) {
  InlineStyles styles;
  const std::string body =
      api_page(site_.course, site_.evaluation, renderer.context(styles, kApiPage));
  renderer.write(kApiPage,
                 {"api", kApiTitle,
                  "What " + site_.course.title + " uses of MuJoCo " +
                      site_.evaluation.versions.mujoco + ", as its headers declare it."},
                 body, styles);
  out_.write("api-names.json", site_.evaluation.api_names);
}

void SitePages::write_gallery(PageRenderer& renderer) {
  InlineStyles styles;
  const std::string body =
      gallery_page(site_.course, site_.evaluation, renderer.context(styles, kGalleryPage));
  renderer.write(
      kGalleryPage,
      {"gallery", kGalleryTitle, "The models that " + site_.course.title + " works with."}, body,
      styles);
}

void SitePages::write_model(const ModelPage& model, PageRenderer& renderer) {
  const std::string path = model_page_path(model.name);
  InlineStyles styles;
  const ModelPageHtml page =
      model_page(model, site_.course, site_.evaluation, renderer.context(styles, path));
  renderer.write(path,
                 {"model", model.name,
                  "The model " + model.name + " of " + site_.course.title +
                      ": a live lab, its joints, its MJCF.",
                  way_to_root(path)},
                 page.body, styles);
  write_labs(page.lab_files, out_);
  out_.write(model_poster_path(model) + ".webp", model.poster.webp);
  out_.write(model_poster_path(model) + ".png", model.poster.png);
  for (const ModelPage::File& file : model.files) out_.copy(root_ / file.path, file.path);
}

void SitePages::write_missing(PageRenderer& renderer) {
  InlineStyles styles;
  PageHead head{"missing", "Page not found", "There is no page at this address."};
  head.anywhere = true;
  renderer.write("404.html", head,
                 render_template(renderer.templates(), "missing",
                                 {{"title", head.title}, {"course", site_.course.title}}),
                 styles);
}

void SitePages::write_search(PageRenderer& renderer) {
  InlineStyles styles;
  const PageHead head{"finding", "Search", "What is looked for in " + site_.course.title + "."};
  nlohmann::json places{{{"title", "Lessons"}, {"href", "index.html"}}};
  if (site_.course.glossary) {
    const Lesson& glossary = site_.course.glossary->page;
    places.push_back({{"title", glossary.front.title.text}, {"href", page_path(glossary)}});
  }
  if (!site_.evaluation.api.empty()) places.push_back({{"title", kApiTitle}, {"href", kApiPage}});
  if (!site_.evaluation.models.empty()) {
    places.push_back({{"title", kGalleryTitle}, {"href", kGalleryPage}});
  }
  renderer.write(kSearchPage, head,
                 render_template(renderer.templates(), "search",
                                 {{"title", head.title}, {"places", std::move(places)}}),
                 styles);
}

// Each program as it is, and those that run, as snippets do, as a folder that builds.
void SitePages::copy_examples() {
  std::set<std::string> files, folders;
  for (std::size_t i = 0; i < site_.course.lessons.size(); ++i) {
    const Lesson& lesson = site_.course.lessons[i];
    for (std::size_t block = 0; block < lesson.blocks.size(); ++block) {
      const auto* result = site_.evaluation.lessons[i].get<ExampleResult>(block);
      if (const auto* example = std::get_if<Example>(&lesson.blocks[block])) {
        if (files.insert(example->file.text).second) copy_program(example->file.text);
        const std::string path = program_zip_path(*example, result);
        if (path.empty() || !folders.insert(path).second) continue;
        out_.write(path, zip_of(program_folder({*example, *result, lesson}, site_)));
      } else if (const auto* exercise = std::get_if<Exercise>(&lesson.blocks[block])) {
        if (site_.solutions && files.insert(exercise->program.file.text).second) {
          copy_program(exercise->program.file.text);
        }
        write_exercise(*exercise, lesson, site_.evaluation.lessons[i].get<ExerciseResult>(block));
      } else if (std::holds_alternative<Snippet>(lesson.blocks[block]) && result != nullptr) {
        const Example program = snippet_program(lesson, block);
        out_.write(program_zip_path(program, result),
                   zip_of(program_folder({program, *result, lesson, result->code}, site_)));
      }
    }
  }
}

// Of an exercise, its solution.
void SitePages::copy_program(const std::string& path) {
  const auto text = files_.read(path);
  const std::string shown = text ? without_exercise(*text) : "";
  if (text && shown != *text) {
    out_.write(path, shown);
  } else {
    out_.copy(root_ / path, path);
  }
}

void SitePages::write_exercise(const Exercise& exercise, const Lesson& lesson,
                               const ExerciseResult* result) {
  if (result == nullptr) return;
  out_.write(exercise_path(exercise), result->starter);
  const ExampleResult taken{result->starter, "", {}, 0, result->files, {}};
  out_.write(exercise_zip_path(exercise),
             zip_of(program_folder({exercise.program, taken, lesson, result->starter}, site_)));
}

}  // namespace mjcourse
