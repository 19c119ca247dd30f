#include "evaluate/work_loop.h"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "evaluate/plan.h"
#include "evaluate/work_message.h"
#include "lesson/read_glossary.h"
#include "lesson/read_lesson.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// False at the end of the stream.
bool read_all(int descriptor, char* to, std::size_t size) {
  while (size > 0) {
    const ssize_t count = read(descriptor, to, size);
    if (count == 0 || (count < 0 && errno != EINTR)) return false;
    if (count < 0) continue;
    to += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool write_all(int descriptor, const char* from, std::size_t size) {
  while (size > 0) {
    const ssize_t count = write(descriptor, from, size);
    if (count < 0 && errno != EINTR) return false;
    if (count < 0) continue;
    from += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

std::optional<std::string> next_message() {
  std::uint64_t size = 0;
  if (!read_all(STDIN_FILENO, reinterpret_cast<char*>(&size), sizeof size)) return std::nullopt;
  std::string message(size, '\0');
  if (!read_all(STDIN_FILENO, message.data(), size)) return std::nullopt;
  return message;
}

bool say(int descriptor, const std::string& message) {
  const std::uint64_t size = message.size();
  return write_all(descriptor, reinterpret_cast<const char*>(&size), sizeof size) &&
         write_all(descriptor, message.data(), message.size());
}

// A course of one page, and all that is to be found out about it.
struct Page {
  std::string text;
  Course course;
  Tasks tasks;
};

class Answerer {
 public:
  Answerer(fs::path root, const Files& assets) : run_context_(course_, std::move(root), assets) {}

  WorkAnswer answer(const WorkQuestion& question) {
    course_.models = question.models;
    if (question.reports) take_reports(*question.reports);
    WorkerContext& worker_context =
        worker_context_ ? *worker_context_ : worker_context_.emplace(run_context_);
    worker_context.trace().clear();
    WorkAnswer answer;
    try {
      Task& task = task_of(question);
      answer.whole = task.work_apart(worker_context, answer.finding);
      worker_context.let_go();
      answer.looked_at = worker_context.trace().names();
      answer.traced = worker_context.trace().complete() && worker_context.trace().sets().empty() &&
                      worker_context.trace().headers().empty();
    } catch (const std::exception& error) {
      answer = {};
      answer.failure = error.what();
      worker_context_.reset();  // it may have left anything there
    }
    return answer;
  }

 private:
  void take_reports(const std::map<std::string, std::optional<Records>>& reports) {
    for (const auto& [example, records] : reports) {
      if (!records) {
        run_context_.reports().add(example, nullptr);
        continue;
      }
      ExampleResult& result = programs_[example];
      result.records = *records;
      run_context_.reports().add(example, &result);
    }
  }

  Task& task_of(const WorkQuestion& question) {
    std::optional<Page>& page = pages_[question.page];
    if (!page || page->text != question.text) read_page(question, page.emplace());
    for (const auto& task : page->tasks) {
      if (task->block() == question.block && task->what() == question.what) return *task;
    }
    throw std::runtime_error("there is no task \"" + question.what + "\" in " + question.page);
  }

  void read_page(const WorkQuestion& question, Page& page) {
    page.text = question.text;
    page.course.models = question.models;
    Diagnostics known;  // the generator that asks has them
    if (question.page == kGlossaryPath) {
      page.course.glossary = read_glossary(question.text, known);
    } else if (auto lesson = read_lesson(question.page, question.text, known)) {
      page.course.add(*std::move(lesson));
    }
    page.tasks = plan_tasks(page.course);
  }

  Course course_;  // without lessons, which no task looks at but at its own
  RunContext run_context_;
  std::optional<WorkerContext> worker_context_;
  std::map<std::string, std::optional<Page>> pages_;
  std::map<std::string, ExampleResult> programs_;
};

}  // namespace

void answer_questions(const fs::path& root, const Files& assets) {
  // Whatever a library prints must not come between answers.
  const int answers = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  Answerer answerer(root, assets);
  while (const auto message = next_message()) {
    const auto question = decode_question(*message);
    if (!question) throw std::runtime_error("this is no question");
    if (!say(answers, encode(answerer.answer(*question)))) return;
  }
}

}  // namespace mjcourse
