// `mjcourse list`: the lessons in their order, and how each of them stands.
#include <algorithm>
#include <array>
#include <iostream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "base/counted.h"
#include "base/utf8.h"
#include "cli/commands.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "course/last_changed.h"
#include "lesson/unloaded_lesson.h"
#include "page/html/verification.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

using Row = std::array<std::string, 8>;

const Row kHead{"", "lesson", "words", "minutes", "proved", "asserted", "open", "changed"};

std::size_t count_words(const std::string& text) {
  std::istringstream words(text);
  return static_cast<std::size_t>(std::distance(std::istream_iterator<std::string>(words), {}));
}

// Of the text that a reader sees: programs, labs and quizzes are no words.
std::size_t count_words(const Lesson& lesson, const Files& files) {
  const Lesson whole = reload(lesson, files);
  const std::unique_ptr<cmark_iter, decltype(&cmark_iter_free)> walk(
      cmark_iter_new(whole.document.get()), cmark_iter_free);
  std::size_t words = 0;
  for (cmark_event_type event; (event = cmark_iter_next(walk.get())) != CMARK_EVENT_DONE;) {
    cmark_node* node = cmark_iter_get_node(walk.get());
    const std::string type = cmark_node_get_type_string(node);
    const bool has_text = type == "paragraph" || type == "heading" || type == "table_cell";
    if (event == CMARK_EVENT_ENTER && has_text) words += count_words(plain_text(node));
  }
  return words;
}

// Cited counts as proved: neither is left to do. What is not run is open, and so is what failed.
Row row_of(const Lesson& lesson, const Claims& claims, const Files& files,
           const LastChanges& changes) {
  const StatusCounts counts = counts_of(claims);
  const auto count = [&](Claim::Status status) {
    return counts.at(static_cast<std::size_t>(status));
  };
  const auto shown = [](auto number) { return number == 0 ? "" : std::to_string(number); };
  const auto change = changes.find(lesson.source->path());
  const std::string& title = lesson.front.title.text;
  return {lesson.number,
          readable(title.empty() ? lesson.slug : title) + (lesson.front.draft ? " (draft)" : ""),
          shown(count_words(lesson, files)),
          lesson.front.minutes ? std::to_string(*lesson.front.minutes) : "",
          shown(count(Claim::Status::proved) + count(Claim::Status::cited)),
          shown(count(Claim::Status::asserted)),
          shown(count(Claim::Status::unchecked) + count(Claim::Status::failed)),
          change == changes.end()      ? ""
          : change->second.committed() ? change->second.day
                                       : "not committed"};
}

// Columns as wide as what is in them; numbers to the right.
void print(const std::vector<Row>& rows) {
  std::array<int, kHead.size()> widths{};
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      widths.at(c) = std::max(widths.at(c), count_columns(row.at(c)));
    }
  }
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const int missing = widths.at(c) - count_columns(row.at(c));
      const std::string gap(static_cast<std::size_t>(missing), ' ');
      const bool is_number = c >= 2 && c <= 6;
      line += (c == 0 ? "" : "  ") + (is_number ? gap + row.at(c) : row.at(c) + gap);
    }
    std::cout << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
  }
}

}  // namespace

int list(const ListOptions& options) {
  Verified verified = read_course_of(options);
  evaluate_course(options, verified, true);
  if (!verified.course) {
    print_diagnostics(verified.evaluation.diagnostics);
    return kCourseErrors;
  }
  const Course& course = *verified.course;
  const DiskFiles files(options.course);
  const LastChanges changes = last_changed(options.course, "content").changes;
  std::vector<Row> rows{kHead};
  for (const Lesson& lesson : course.lessons) {
    rows.push_back(row_of(lesson, verified.evaluation.results_of(lesson).claims, files, changes));
  }
  print(rows);
  const std::ptrdiff_t errors = count_errors(verified.evaluation.diagnostics);
  if (errors > 0)
    std::cout << counted(errors, "error") << "; " << our_command("check") << " shows them\n";
  return errors > 0 ? kCourseErrors : kClean;
}

}  // namespace mjcourse
