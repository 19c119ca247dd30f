#include "evaluate/work_loop.h"

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "evaluate/plan.h"
#include "evaluate/work_message.h"
#include "lesson/read_glossary.h"
#include "lesson/read_lesson.h"
#include "process/question_stream.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

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
  const QuestionStream questions;
  Answerer answerer(root, assets);
  while (const auto message = questions.next()) {
    const auto question = decode_question(*message);
    if (!question) throw std::runtime_error("this is no question");
    if (!questions.answer(encode(answerer.answer(*question)))) return;
  }
}

}  // namespace mjcourse
