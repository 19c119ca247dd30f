#include "evaluate/worker.h"

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/temporary_folder.h"
#include "evaluate/work_message.h"
#include "process/mesa.h"
#include "process/open_to_all.h"
#include "process/process_supervisor.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Of one answer: a film of a minute is some ten megabytes.
constexpr std::size_t kMostAnswer = 256 << 20;
// As long as the longest check, for a limit of the kernel's when nobody is left to look.
constexpr double kLifetime = 24 * 3600;

// Of what lies in the course's folder: its models, and the pictures that others are held against.
std::vector<std::string> readable_of(const fs::path& root) {
  std::vector<std::string> paths;
  for (const char* folder : {"models", "content"}) {
    // A link there would open whatever it leads to.
    if (DiskFiles(root).is_folder(folder)) paths.push_back((root / folder).string());
  }
  return paths;
}

Command command_of(const WorkerProgram& program, const fs::path& root, const fs::path& folder,
                   const WorkLimits& limits) {
  Command command;
  command.arguments = {program.file.string(), kWorkCommand, root.string(), program.assets.string()};
  command.folder = folder.string();
  command.seconds = kLifetime;
  command.output_bytes = kMostAnswer;
  command.answers = true;
  Sandbox sandbox;
  sandbox.read = readable_of(root);
  sandbox.read.push_back(program.file.string());
  sandbox.read.push_back(program.assets.string());
  for (const std::string& path : sandbox.read) {
    if (!can_be_read_by_all(path)) sandbox.reads_all = true;
  }
  sandbox.write = {folder.string()};
  sandbox.processes = true;  // models are tried, and films made, in children
  sandbox.memory_bytes = limits.memory;
  sandbox.reserves = true;
  sandbox.file_bytes = sandbox.folder_bytes = 4ull << 30;  // a film's pictures
  sandbox.open_files = 256;
  const LentShaders shaders = lend_shaders_to(folder / "shaders");
  command.environment = shaders.variables;
  sandbox.write.push_back(shaders.own.string());
  if (!shaders.ours.empty()) sandbox.read.push_back(shaders.ours.string());
  command.sandbox = std::move(sandbox);
  return command;
}

std::string signal_name(int number) {
  const char* const name = sigabbrev_np(number);
  return name == nullptr ? "signal " + std::to_string(number) : "SIG" + std::string(name);
}

Diagnostic end_of(const Task& task, const Outcome& outcome, const WorkLimits& limits) {
  using End = Outcome::End;
  const auto wrong = [&](const char* id, const std::string& message, const std::string& cure) {
    return error_at(task.place(), id, message, cure);
  };
  switch (outcome.end) {
    case End::timed_out:
      return wrong("E-work-time",
                   "this takes more than " + std::to_string(std::lround(limits.seconds)) + " s" +
                       " to work out",
                   "make it smaller: fewer controls or questions, shorter runs, a smaller model");
    case End::exhausted:
      return wrong(
          "E-work-memory",
          "this takes more than " + std::to_string(limits.memory >> 20) + " MiB" + " of memory",
          std::string("look for a list that grows in a script, or a large number in a model") +
              (limits.memory < WorkLimits{}.memory
                   ? "; with fewer workers, each has more of this machine's memory: `--jobs 1`"
                   : ""));
    case End::killed_by_signal:
      return wrong(
          "E-work-crash", "the process that works on this ended with " + signal_name(outcome.code),
          "MuJoCo or the script engine crashed: look for indices and sizes that do not fit "
          "the model");
    case End::refused:
      return wrong("E-work-refused",
                   "the process that works on this tried to " + outcome.refused +
                       ", which nothing in a course may do",
                   "what a script or a model does must stay in its simulation");
    default:
      break;
  }
  const std::string said = outcome.err.substr(0, outcome.err.find('\n'));
  return wrong(
      "E-work-crash",
      "the process that works on this ended without an answer" + (said.empty() ? "" : ": " + said),
      "");
}

}  // namespace

class Worker::Process {
 public:
  Process(const WorkerProgram& program, const fs::path& root, const WorkLimits& limits)
      : command_(command_of(program, root, folder_.path(), limits)), supervisor_(command_) {}

  tl::expected<std::string, Outcome> ask(const std::string& question, double seconds) {
    return supervisor_.ask(question, seconds);
  }

  // Does it know what programs told? They are published once.
  bool knows_reports = false;

 private:
  TemporaryFolder folder_;
  Command command_;
  ProcessSupervisor supervisor_;
};

Worker::Worker(const RunContext& run_context, WorkerProgram program, WorkLimits limits)
    : run_context_(run_context), program_(std::move(program)), limits_(limits) {}

Worker::~Worker() = default;

bool Worker::work(const Task& task, Trace& trace, Finding& finding) {
  if (auto why = run_context_.why_nothing_runs()) {
    why->place = task.place();
    finding.diagnostics.push_back(*std::move(why));
    return false;
  }
  const SourceText& source = *task.lesson().source;
  WorkQuestion question{run_context_.course().models, source.path(), std::string(source.text()),
                        task.block(), task.what()};
  auto process = std::move(process_);
  if (!process) process = std::make_unique<Process>(program_, run_context_.root(), limits_);
  if (task.quotes() && !process->knows_reports) {
    question.reports = run_context_.reports().records();
    process->knows_reports = true;
  }
  const auto said = process->ask(encode(question), limits_.seconds);
  if (!said) {
    finding.diagnostics.push_back(end_of(task, said.error(), limits_));
    trace.unknown();
    return false;
  }
  auto answer = decode_answer(*said, task, run_context_.root());
  if (!answer) throw std::runtime_error("the process that works on this gave no answer to it");
  process_ = std::move(process);
  if (!answer->failure.empty()) throw std::runtime_error(answer->failure);
  trace.add(answer->looked_at);
  if (!answer->traced) trace.unknown();
  Diagnostics said_before = std::move(finding.diagnostics);
  finding = std::move(answer->finding);
  finding.diagnostics.insert(finding.diagnostics.begin(), said_before.begin(), said_before.end());
  return answer->whole;
}

}  // namespace mjcourse
