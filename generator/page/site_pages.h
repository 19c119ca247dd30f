// SitePages: the pages of a site, with the files that they show, written in whatever order is
// wanted and to wherever it is wanted.
//
// Enter with write_lesson() for each lesson and write_others() for all the rest; site.h does both
// for a site on the disk.
// Tested by tests/generator/cli/build_test.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "page/lesson_parts.h"
#include "page/page_renderer.h"
#include "page/printed_course.h"
#include "page/site_data.h"

namespace mjcourse {

class SitePages {
 public:
  // `root` is the course's folder, `assets` what site/bundle/build.mjs made; these, the course and
  // what came of it must outlive this.
  SitePages(const Course& course, const Evaluation& evaluation, const std::filesystem::path& root,
            const Files& assets, SiteFiles& out, bool places = false, LastChanges changes = {},
            OutlineClaims claims_of_outline = {});

  // Lesson `index` with its files, be it a draft; what write_others() needs of it is made as well,
  // unless it is written `alone`. From several threads, each with engines of its own and another
  // lesson.
  void write_lesson(std::size_t index, PageEngines& engines, bool alone = false);

  // The home page, what was verified, the pages that explain, the search, the examples, what other
  // sites read: with what each lesson gave to them, so all lessons but the drafts must have been
  // written.
  void write_others(PageEngines& engines);

  // Of a course without them (without_solutions.h): nor do exercises lead to theirs.
  void withhold_solutions() { site_.solutions = false; }

 private:
  // Gives the body, which is printed with the course as well.
  std::string write_glossary(PageRenderer& renderer);
  void write_api(PageRenderer& renderer);
  void write_gallery(PageRenderer& renderer);
  void write_model(const ModelPage& model, PageRenderer& renderer);
  // For addresses at which there is nothing: hosts show it in the place of what is not there.
  void write_missing(PageRenderer& renderer);
  void write_search(PageRenderer& renderer);
  void copy_examples();
  void copy_program(const std::string& path);
  void write_exercise(const Exercise& exercise, const Lesson& lesson, const ExerciseResult* result);

  std::filesystem::path root_;
  SiteFiles& out_;
  DiskFiles files_;  // the course's
  SiteData site_;
  Spool spool_;
  std::vector<LessonParts> parts_;  // of the lessons, and the glossary's
  PrintedLength printed_;
};

}  // namespace mjcourse
