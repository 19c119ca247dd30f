#include "toolchain/compiler.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/cpp_includes.h"
#include "base/files.h"
#include "toolchain/driver_steps.h"
#include "toolchain/warm_header.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Hidden, because a program may have any other name.
constexpr const char* kDependencies = ".dependencies";
constexpr const char* kOverlay = ".overlay.json";
constexpr const char* kObject = ".program.o";
constexpr const char* kPreprocessed = ".program.ii";
constexpr const char* kNeedsMuch = "needed more than 4 GiB of memory, and was stopped";

template <typename... Words>
void append(std::vector<std::string>& command, const Words&... words) {
  (command.push_back(words), ...);
}

// What kept the compiler from an answer, in words; empty where it gave one.
std::string why_stopped(const Outcome& outcome) {
  switch (outcome.end) {
    case Outcome::End::timed_out:
      return "still ran after " + std::to_string(static_cast<int>(kToolSeconds)) +
             " s, and was stopped";
    case Outcome::End::flooded:
      return "complained for more than 1 MiB, and was stopped";
    case Outcome::End::overfilled:
      return "wrote more than 1 GiB, and was stopped";
    case Outcome::End::exhausted:
      return kNeedsMuch;
    default:
      break;
  }
  if (outcome.code == 0) return "";
  for (const char* words : {"out of memory", "Cannot allocate memory", "bad_alloc"}) {
    if (outcome.err.find(words) != outcome.err.npos) return kNeedsMuch;
  }
  // After the stack of calls in which it did.
  if (outcome.err.find("PLEASE submit a bug report") != outcome.err.npos) return "crashed";
  return outcome.err.find("File too large") != outcome.err.npos
             ? "wrote more than 1 GiB, and was stopped"
             : "";
}

struct WorkFolder {
  fs::path folder;
  std::vector<fs::path> reads;
  // Of a trial whose messages do not count: the paths that another program has otherwise.
  std::vector<std::string> names;
};

// Run one step of a compilation: what it said and read is added to `compiled`.
void take(std::vector<std::string> command, const WorkFolder& at, Compiled& compiled) {
  const auto& [folder, reads, names] = at;
  append(command, "-MD", "-MF", kDependencies);
  fs::remove(folder / kDependencies);
  // Each tool runs as a user of its own, and may not write into another's file.
  const auto out = std::ranges::find(command, "-o");
  if (out != command.end()) fs::remove(*std::next(out));
  if (!names.empty()) command = without_driver(command, names, folder, reads);
  const Outcome outcome = run_tool(std::move(command), folder, reads);
  compiled.succeeded = succeeded(outcome);
  compiled.raw += outcome.err;
  compiled.stopped = why_stopped(outcome);
  compiled.crashed = !compiled.stopped.empty() && (outcome.end == Outcome::End::exited ||
                                                   outcome.end == Outcome::End::killed_by_signal);
  const auto rule = DiskFiles(folder).read(kDependencies);
  if (!rule) {
    compiled.dependencies.reset();
    return;
  }
  std::vector<std::string> all;
  std::ranges::set_union(*compiled.dependencies, parse_dependencies(*rule, folder),
                         std::back_inserter(all));
  compiled.dependencies = std::move(all);
}

void leave_out(const WarmObjects::Entry& entry, Compiled& compiled) {
  if (!entry || !compiled.dependencies) return;
  std::vector<std::string> rest;
  std::ranges::set_difference(*compiled.dependencies, entry->inputs, std::back_inserter(rest));
  // What the entry itself consists of is as good as its inputs.
  const std::string own = entry->folder.parent_path().string() + "/";
  std::erase_if(rest, [&](const std::string& file) { return file.starts_with(own); });
  compiled.dependencies = std::move(rest);
}

}  // namespace

struct Compiler::Program {
  fs::path source, binary, folder, beside;
  std::vector<std::string> libraries;
  bool optimize = false, ours = true;
};

bool Compiled::refused() const {
  return !succeeded && std::any_of(messages.begin(), messages.end(), [](const auto& message) {
    return message.severity == "error" || message.severity == "fatal error";
  });
}

std::optional<Compiler> Compiler::find(IncludeFolders include, std::optional<fs::path> prepared) {
  std::optional<Toolchain> toolchain = Toolchain::find();
  if (!toolchain) return std::nullopt;
  return Compiler(*std::move(toolchain), std::move(include), std::move(prepared));
}

Compiler::Compiler(Toolchain toolchain, IncludeFolders include, std::optional<fs::path> prepared)
    : toolchain_(std::move(toolchain)),
      include_(std::move(include)),
      warm_(std::make_shared<WarmObjects>(toolchain_, std::move(prepared), include_)) {}

bool Compiler::makes_headers() const {
  return warm_->makes_headers();
}

bool Compiler::has_header(const std::vector<std::string>& roots) const {
  return warm_->header(roots) != nullptr;
}

void Compiler::make_header(const std::vector<std::string>& roots, Warmth warmth) const {
  warm_->make_header(roots, warmth);
}

std::vector<std::string> Compiler::command_of(const Program& program,
                                              const WarmObjects::Entry& header) const {
  std::vector<std::string> command =
      toolchain_.command(program.optimize, header ? warm_->headers().shown() : include_);
  if (!program.beside.empty()) {
    append(command, "-iquote", program.beside.string(),
           file_names_in(program.beside, program.beside.filename().string()));
  }
  if (!header) return command;
  const fs::path overlay = program.folder / kOverlay;
  write_file(overlay, warm_->headers().overlay(header->folder.parent_path() / "header.hpp"));
  append(command, "-ivfsoverlay", overlay.string(), "-include-pch",
         (header->folder / "header.pch").string());
  return command;
}

Compiled Compiler::attempt(const Program& program, const WarmObjects::Entry& header,
                           const WarmObjects::Entry& handlers, bool fast) const {
  std::vector<std::string> command = command_of(program, header), link;
  const fs::path object = header ? header->folder / "header.o" : fs::path();
  if (header && fs::exists(object)) append(link, object.string());
  append(command, program.source.string());
  if (handlers) append(link, (handlers->folder / "handlers.o").string());
  for (const std::string& library : program.libraries) append(link, "-l" + library);
  append(link, "-o", program.binary.string());
  // Of the warm header a program needs little, and its build nobody has to name. Other programs
  // are built meanwhile.
  if (fast && toolchain_.has_mold) {
    append(link, "-fuse-ld=mold", "-Wl,--gc-sections", "-Wl,--no-build-id", "-Wl,--thread-count=1");
  }

  WorkFolder at{program.folder, program.ours ? read_for(include_) : include_, {}};
  for (const WarmObjects::Entry& entry : {header, handlers}) {
    if (entry) at.reads.push_back(entry->folder.parent_path());
  }
  if (fast && toolchain_.is_clang()) at.names = {program.source, program.binary, program.folder};

  Compiled compiled;
  const fs::path source = handlers_source(include_);
  if (handlers || source.empty()) {  // a course may do without handlers
    command.insert(command.end(), link.begin(), link.end());
    take(command, at, compiled);
  } else {
    // In two steps, as a compiler lists the files of one source alone.
    const std::string compiled_object = program.folder / kObject;
    append(command, "-c", "-o", compiled_object);
    take(command, at, compiled);
    command = command_of(program, nullptr);
    append(command, compiled_object, source.string());
    command.insert(command.end(), link.begin(), link.end());
    if (compiled.succeeded) take(command, at, compiled);
  }
  compiled.messages = parse_messages(compiled.raw);
  if (header && compiled.dependencies) {
    std::erase(*compiled.dependencies, CourseHeaders::kSource);
    for (std::string& file : *compiled.dependencies) file = warm_->headers().true_path(file);
    std::ranges::sort(*compiled.dependencies);
  }
  for (const WarmObjects::Entry& entry : {header, handlers}) {
    leave_out(entry, compiled);
  }
  compiled.header = header;
  compiled.handlers = handlers;
  return compiled;
}

std::optional<std::string> Compiler::preprocess(const fs::path& source, const fs::path& folder,
                                                bool optimize, const fs::path& beside,
                                                bool ours) const {
  const std::string text =
      DiskFiles(source.parent_path()).read(source.filename().string()).value_or("");
  const Program program{source, {}, folder, beside, {}, optimize, ours};
  WarmObjects::Entry header;
  if (!optimize) header = warm_->header(warm_roots(text, include_));
  std::vector<std::string> command = command_of(program, header);
  append(command, "-E", "-w", source.string(), "-o", (folder / kPreprocessed).string());
  std::vector<fs::path> reads = ours ? read_for(include_) : include_;
  if (header) reads.push_back(header->folder.parent_path());
  if (!succeeded(run_tool(std::move(command), folder, reads))) return std::nullopt;
  const auto made = DiskFiles(folder).read(kPreprocessed);
  return made ? std::optional(*made) : std::nullopt;
}

Compiled Compiler::compile(const fs::path& source, const fs::path& binary, const fs::path& folder,
                           bool optimize, const fs::path& beside, bool ours) const {
  // What cannot be read, the compiler will say.
  const std::string text =
      DiskFiles(source.parent_path()).read(source.filename().string()).value_or("");
  const Program program{source, binary, folder, beside, linked_libraries(text), optimize, ours};
  const WarmObjects::Entry handlers = warm_->handlers();
  WarmObjects::Entry header;
  if (!optimize) header = warm_->header(warm_roots(text, include_));
  const auto silent = [](const Compiled& compiled) {
    return compiled.succeeded && compiled.raw.empty();
  };
  if (header || toolchain_.has_mold) {
    Compiled fast = attempt(program, header, handlers, true);
    // A compiler that crashes may have read a damaged header.
    const bool is_slow = !fast.stopped.empty() && !fast.crashed;
    if (silent(fast) || is_slow) return fast;
  }
  Compiled compiled = attempt(program, nullptr, handlers, false);
  // Then it was the header that was at fault.
  if (header && silent(compiled)) WarmObjects::drop(header);
  if (!handlers || silent(compiled) || compiled.refused()) return compiled;
  // What does not link may lack the handlers alone.
  Compiled bare = attempt(program, nullptr, nullptr, false);
  if (!silent(bare)) return compiled;
  WarmObjects::drop(handlers);
  return bare;
}

}  // namespace mjcourse
