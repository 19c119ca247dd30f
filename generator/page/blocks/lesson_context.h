// LessonContext: a lesson while its page is written: what the data of its blocks is made from, and
// what is noted on the way.
//
// The functions that make the data of a block (block_data.h and its kin) get this. It writes the
// Markdown inside a block by PageWriter, which sets `writer`.
// Tested by tests/generator/page/blocks/page_writer_test.cpp.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "course/course.h"
#include "findings/lesson_results.h"
#include "page/html/inline_styles.h"
#include "page/html/markdown_html.h"
#include "script/highlight.h"
#include "script/templates.h"

namespace mjcourse {

// The tools that all pages share.
struct PageContext {
  Templates& templates;
  Highlighter& highlighter;
  const nlohmann::json& manifest;  // the way from a plain name of an asset to its path
  InlineStyles& styles;            // of the page being written
  // The page being written, below the site's root; "" for the lesson's own.
  std::string page = {};
  // What each term of the glossary means, by its key (page/glossary_page.h).
  const std::map<std::string, std::string>* definitions = nullptr;
  bool places = false;  // a lesson's text has its lines in comments (page/html/place_marks.h)
  std::size_t compiler_bytes = 0;  // of the site's compiler of C++ (page/blocks/program_data.h)
  bool solutions = true;           // exercises have the address of theirs
};

// What stands on the site beside a lab's page, by path below the root.
struct LabFiles {
  std::string module;                                   // the path of the module among `written`
  std::map<std::string, std::string> written;           // bytes
  std::map<std::string, std::filesystem::path> copied;  // files on the disk
};

struct LessonContext {
  // All must outlive this.
  LessonContext(const Course& of_course, const Lesson& of_lesson, const LessonResults& of_results,
                PageContext of_page);

  std::string html(const Document& document) const { return render_html(document.get(), writer); }
  std::string inline_html(const Document& document) const {
    return render_inline_html(document.get(), writer);
  }
  // For a script to put into the page: the stylesheet of the page has what it needs.
  std::string scripted_html(const Document& document) const {
    return page.styles.take(html(document));
  }
  // The way from the page being written to a file below the site's root.
  std::string from_root(const std::string& path) const;
  // `wanted`, with a number behind it where the page has it already.
  std::string unique_id(const std::string& wanted);
  // A heading for the list of contents, of level 2 or 3; others are not in it.
  void list_heading(int level, const std::string& id, const std::string& title);

  const Course& course;
  const Lesson& lesson;
  const LessonResults& results;
  PageContext page;
  NodeWriter writer;
  nlohmann::json contents = nlohmann::json::array();  // the headings, as a two-level list
  nlohmann::json answers = nlohmann::json::array();   // as answers.hbs wants them
  std::vector<LabFiles> lab_files;

 private:
  std::set<std::string> ids_;  // of listings
};

}  // namespace mjcourse
