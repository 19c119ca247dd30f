#include "page/lesson_files.h"

#include <optional>
#include <string>

#include "lesson/unloaded_lesson.h"
#include "page/course_data.h"
#include "page/html/csv.h"
#include "page/html/lesson_pictures.h"
#include "page/html/site_paths.h"
#include "page/lesson_page.h"
#include "page/printed_course.h"
#include "page/search_index.h"
#include "page/site_data.h"
#include "page/web_files.h"
#include "page/without_solutions.h"

namespace mjcourse {
namespace {

void write_pictures(const Lesson& lesson, const LessonResults& results, SiteFiles& directory) {
  for (const LessonPicture& picture : pictures_of(lesson, results)) {
    directory.write(picture.path + ".webp", picture.poster->webp);
    directory.write(picture.path + ".png", picture.poster->png);
    if (picture.film != nullptr && !picture.film->empty()) {
      directory.write(picture.path + ".mp4", *picture.film);
    }
  }
}

// What a plot shows, and what draws it again of other numbers.
void write_plots(const Lesson& lesson, const LessonResults& results, SiteFiles& directory) {
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* plot = std::get_if<Plot>(&lesson.blocks[i]);
    const auto* result = results.get<PlotResult>(i);
    if (plot == nullptr || result == nullptr) continue;
    directory.write(block_path(lesson, i) + ".csv", csv_of(result->table));
    directory.write(block_path(lesson, i) + ".json", plot->json);
  }
}

}  // namespace

void write_labs(const std::vector<LabFiles>& labs, SiteFiles& directory) {
  for (const LabFiles& files : labs) {
    for (const auto& [path, bytes] : files.written) directory.write(path, bytes);
    for (const auto& [path, file] : files.copied) directory.copy(file, path);
  }
}

void copy_images(const Lesson& page, const LessonResults& results, SiteFiles& directory) {
  for (std::size_t i = 0; i < page.blocks.size(); ++i) {
    const auto* image = std::get_if<Image>(&page.blocks[i]);
    const auto* result = results.get<ImageResult>(i);
    if (image == nullptr || result == nullptr) continue;
    directory.copy(result->file, image_path(page, *image, *result));
  }
}

void write_lesson(const SiteData& site, std::size_t index, PageRenderer& renderer,
                  SiteFiles& directory, Spool& spool, PrintedLength& printed, LessonParts* parts) {
  const Lesson& unloaded = site.course.lessons[index];
  std::optional<Lesson> reloaded;
  if (unloaded.kept != Lesson::Kept::all) {
    reloaded = reload(unloaded, site.files);
    if (!site.solutions) withhold_solutions(*reloaded, exercise_programs(site.course));
  }
  const Lesson& lesson = reloaded ? *reloaded : unloaded;
  const LessonResults& results = site.evaluation.lessons[index];
  const std::string path = page_path(lesson);
  InlineStyles styles;
  PageWriter writer(site.course, lesson, results, renderer.context(styles, path));
  const LessonPage page = lesson_page(site, lesson, index, writer, renderer.templates());
  const Document& summary = lesson.front.summary;
  const std::string description = summary ? plain_text(summary.get()) : site.course.description;
  const std::optional<SharedPicture> picture = shared_picture(lesson, results);
  renderer.write(path,
                 {"lesson", lesson.number + " " + lesson.front.title.text, description, "../",
                  &unloaded, picture},
                 page.body, styles);
  write_pictures(lesson, results, directory);
  copy_images(lesson, results, directory);
  write_plots(lesson, results, directory);
  write_labs(writer.lab_files(), directory);

  if (parts == nullptr) return;
  const bool is_outline = unloaded.kept == Lesson::Kept::outline;
  *parts = verification_parts(lesson, is_outline ? site.claims_of_outline(lesson) : results.claims,
                              renderer.templates(), spool);
  add_search_part(lesson, results, search_share(site.course), spool, *parts);
  if (printed.fits()) {
    add_printed_parts(site, lesson, page, writer, renderer.templates(), spool, *parts);
    printed.add(*parts);
  }
  parts->picture = picture;
  parts->news =
      spool.put(feed_entry(site, lesson, summary ? description : "", renderer.templates()));
  const bool beside = level_of(site.course, lesson).number.empty();
  const CardPlace place =
      beside ? CardPlace::beside : (index == 0 ? CardPlace::first : CardPlace::within);
  const PageWriter home(site.course, lesson, results, renderer.context(styles, "index.html"));
  parts->card = spool.put(home_card(lesson, results, place, home, renderer.templates()));
  PageWriter review(site.course, lesson, results, renderer.context(styles, kReviewPage));
  const AskedOfReader asked{review.questions(), review.exercises()};
  parts->progress = spool.put(progress_row(lesson, asked, renderer.templates()));
  parts->review = spool.put(review_json(lesson, asked, renderer.templates()));
}

}  // namespace mjcourse
