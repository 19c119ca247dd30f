// Task: a unit of evaluation, which runs by itself on any thread, and whose finding can be kept.
//
// What always holds: a task sees the lesson, the course's files by the worker context's trace, and
// what its recipe names; nothing else. So a finding that was kept under both is what working would
// give.
// Tested by tests/generator/evaluate/worker_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/utf8.h"
#include "cache/dependency.h"
#include "evaluate/context/worker_context.h"
#include "findings/finding.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

class Task {
 public:
  // `page` is the index of `lesson` in Course::pages, `block` its first block that this is about.
  Task(const Lesson& lesson, std::size_t page, std::size_t block, const std::string& what)
      : lesson_(lesson), page_(page), block_(block), what_(readable(what)) {}
  virtual ~Task() = default;
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  const Lesson& lesson() const { return lesson_; }
  std::size_t page() const { return page_; }
  std::size_t block() const { return block_; }
  // "rehearse the lab …", on one line of what a terminal shows: it has words of the course.
  const std::string& what() const { return what_; }
  Place place() const;  // where the block begins

  // All blocks that it finds results of.
  virtual std::vector<std::size_t> blocks() const { return {block_}; }
  // The model whose page it makes; "" where it makes none.
  virtual std::string model() const { return ""; }
  // What of its lesson it is, also after an edit.
  virtual std::string name() const { return what_; }
  // What of its course it is.
  std::string name_in_course() const { return lesson().source->path() + " " + name(); }
  // The names of examples that it may quote: all programs must have been run.
  virtual std::vector<std::string> quoted() const { return {}; }
  bool quotes() const { return !quoted().empty(); }
  // Must all programs have been run?
  virtual bool waits_for_programs() const { return quotes(); }
  // Is it what programs are in the page?
  virtual bool is_in_page() const { return false; }
  // Is anything compiled?
  virtual bool compiles() const { return false; }
  // Of what compiles, once it was prepared: is it likely that all of that was done before?
  virtual bool is_compiled(WorkerContext&) const { return false; }
  // What it will compile includes these (warm_header.h); known once it was prepared.
  virtual std::vector<std::string> warm_roots(const RunContext&) const { return {}; }
  // Are models drawn?
  virtual bool draws() const { return false; }
  // About how many seconds of work: the longest begins first.
  virtual double effort() const { return 0.01; }
  // What it depends on as is known before; `kind` and `text` at least. No names, for what is never
  // kept.
  virtual Dependencies recipe(const RunContext& run_context) const = 0;

  // Does MuJoCo, or the script engine, work on what an author wrote? That is work_apart().
  virtual bool is_apart() const { return false; }

  // Called in this order. First what is looked at each time, which gives false where nothing more
  // can be done. Then the work, unless its finding was kept: it gives false where something is
  // missing, and its first part is done in a process of its own (worker.h). Last what takes all of
  // the finding.
  virtual bool prepare(WorkerContext&, Finding&) { return true; }
  virtual bool work_apart(WorkerContext&, Finding&) { return true; }
  virtual bool work(WorkerContext&, Finding&) { return true; }
  virtual void conclude(WorkerContext&, Finding&) {}

  // After prepare(): what the programs of the same blocks are in the page (page_task.h). `native`
  // is what was found of them natively, where that is known of this run; else null.
  virtual bool work_in_page(WorkerContext&, const Finding* /*native*/, Finding&) { return true; }
  // The name in the course of the task that runs the same natively; and, before work(), the finding
  // of that task.
  virtual std::string native_name() const { return ""; }
  virtual void take_native(const Finding&) {}

 private:
  const Lesson& lesson_;
  std::size_t page_, block_;
  std::string what_;
};

}  // namespace mjcourse
