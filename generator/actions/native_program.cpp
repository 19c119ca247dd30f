#include "actions/native_program.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "actions/native_trace.h"
#include "actions/program_files.h"
#include "base/arithmetic.h"
#include "base/cpp_includes.h"
#include "base/files.h"
#include "base/out_folder.h"
#include "base/plain_name.h"
#include "base/sha256.h"
#include "base/stopwatch.h"
#include "cache/cbor.h"
#include "process/loaded_libraries.h"
#include "process/mesa.h"
#include "process/open_to_all.h"
#include "toolchain/containment.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t kMostRecords = 16 << 20;  // bytes

std::string bytes_of(const NativeRun& run) {
  return to_cbor({{"code", run.outcome.code},
                  {"out", run.outcome.out},
                  {"records", *run.records},
                  {"seconds", run.seconds},
                  {"files", run.files}});
}

// A store may hold anything.
std::optional<NativeRun> run_of(const std::string& bytes) {
  const std::optional<json> all = from_cbor(bytes);
  if (!all) return std::nullopt;
  try {
    NativeRun run;
    run.outcome.end = Outcome::End::exited;
    run.outcome.code = all->at("code").get<int>();
    run.outcome.out = all->at("out").get<std::string>();
    run.records = all->at("records").get<std::string>();
    run.seconds = all->at("seconds").get<double>();
    run.files = all->at("files").get<std::vector<std::string>>();
    // They become names in a reader's archive.
    const bool are_paths = std::ranges::none_of(run.files, [](const std::string& file) {
      return fault_of_path(file, Hidden::is_allowed).has_value();
    });
    return are_paths ? std::optional(std::move(run)) : std::nullopt;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

// `text` without the folders that this build happened to use.
std::string without_folders(std::string text, const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    const std::string prefix = folder.lexically_normal().string() + "/";
    for (std::size_t at = 0; (at = text.find(prefix, at)) != text.npos;)
      text.erase(at, prefix.size());
  }
  return text;
}

}  // namespace

NativeProgram::NativeProgram(NativeSource source, const ActionContext& context)
    : source_(std::move(source)), context_(context), compiling_(context.root) {
  if (!fs::path(source_.file).has_parent_path()) return;  // it is no file of the course
  const fs::path folder =
      fs::absolute(context.root / source_.file).lexically_normal().parent_path();
  for (const std::string& name : quoted_includes(source_.text)) {
    compiling_.file(folder / name);
    if (fs::exists(folder / name)) beside_ = folder;
  }
}

Dependencies NativeProgram::recipe(const std::string& kind,
                                   const std::vector<std::string>& arguments) const {
  std::vector<std::string> text{source_.name, source_.file, source_.text};
  text.insert(text.end(), arguments.begin(), arguments.end());
  Dependencies recipe = action_recipe(kind, text);
  const Toolchain& toolchain = context_.compiler.toolchain();
  recipe.insert(recipe.end(), {{"libraries", loaded_libraries()},
                               {"arithmetic", arithmetic()},
                               {"compiler", toolchain.full_version},
                               {"linker", toolchain.linker},
                               {"flags", compile_flags(source_.optimize)}});
  if (draws(source_.text)) recipe.push_back({"processor", processor_features()});
  return recipe;
}

Dependencies NativeProgram::recipe_of(const NativeRequest& request) const {
  Dependencies all = recipe("native run", request.arguments);
  if (!request.seed.empty()) all.push_back({"seed", request.seed});
  if (request.listener) all.push_back({"listener", sha256(request.listener->key)});
  return all;
}

std::optional<NativeRun> NativeProgram::find(const NativeRequest& request) const {
  if (!request.is_kept) return std::nullopt;
  const auto bytes = context_.store.find(recipe_of(request), context_.trace);
  auto run = bytes ? run_of(*bytes) : std::nullopt;
  const bool is_it =
      run && run->outcome.code == request.exit_code && run->seconds < request.seconds;
  return is_it ? std::move(run) : std::nullopt;
}

std::optional<std::string> NativeProgram::find_refusal() const {
  return context_.store.find(recipe("native refusal"), context_.trace);
}

// With the source in it.
void NativeProgram::make_folder() {
  if (folder_) return;
  begin_ = std::chrono::system_clock::now();
  folder_ = std::make_unique<TemporaryFolder>();
  write_file(source_path(), "#line 1 \"" + source_.file + "\"\n" + source_.text);
  if (!source_.handed_in) return;
  lent_.emplace(beside_, folder_->path() / ".headers" / beside_.filename(), source_.text);
}

const Compiled& NativeProgram::compile() {
  if (compiled_) return *compiled_;
  make_folder();
  binary_ = folder_->path() / source_.name;
  compiled_ = context_.compiler.compile(source_path(), binary_, folder_->path(), source_.optimize,
                                        lent_ ? lent_->folder() : beside_, !source_.handed_in);
  if (lent_) lent_->name_originals(*compiled_);
  IncludeFolders looked_in = context_.compiler.include_folders();
  if (!beside_.empty()) looked_in.push_back(beside_);
  trace_compilation(*compiled_, source_path(), looked_in, context_.root, compiling_);
  context_.trace.add(compiling_);
  return *compiled_;
}

std::optional<std::string> NativeProgram::preprocessed() {
  make_folder();
  return context_.compiler.preprocess(source_path(), folder_->path(), source_.optimize,
                                      lent_ ? lent_->folder() : beside_, !source_.handed_in);
}

std::string NativeProgram::refusal() {
  const fs::path root = fs::absolute(context_.root);
  std::string words = without_folders(compiled_->raw, {root, context_.root, folder_->path()});
  context_.store.keep(recipe("native refusal"), compiling_, begin_, words);
  return words;
}

// The command line that runs the program in an empty folder of its own; what it reports goes into
// the file `records`, where it is none of "".
Command NativeProgram::command_of(const NativeRequest& request, const fs::path& own,
                                  const fs::path& records) const {
  const fs::path& root = context_.root;
  Command command;
  command.arguments = {binary_.string()};
  command.arguments.insert(command.arguments.end(), request.arguments.begin(),
                           request.arguments.end());
  command.folder = own;
  command.environment = {"MJCOURSE_MODELS=" + fs::absolute(root / "models").string()};
  if (!records.empty()) {
    command.environment.push_back("MJCOURSE_RECORDS=" + fs::absolute(records).string());
  }
  if (!request.seed.empty()) command.environment.push_back("MJCOURSE_SEED=" + request.seed);
  command.seconds = request.seconds;
  command.sandbox = program_sandbox(binary_, command.folder, records, root);
  command.record_opened = true;
  if (!draws(source_.text)) return command;
  const OutFolder folder = OutFolder(folder_->path()).inner(own.filename().string() + ".shaders");
  const LentShaders shaders = lend_shaders_to(folder.path());
  command.environment.insert(command.environment.end(), shaders.variables.begin(),
                             shaders.variables.end());
  command.sandbox->write.push_back(shaders.own);
  if (!shaders.ours.empty()) {
    command.sandbox->read.push_back(shaders.ours);
    if (!can_be_read_by_all(shaders.ours)) command.sandbox->reads_all = true;
  }
  return command;
}

NativeRun NativeProgram::run(const NativeRequest& request) {
  const fs::path& folder = folder_->path();
  // Hidden, because a program may have any other name; and none has been there before, so what a
  // former run left behind lies elsewhere.
  const std::string run_name = ".run-" + std::to_string(++runs_);
  const fs::path records = request.listener ? "" : folder / (run_name + ".records");
  const OutFolder out(folder);
  out.inner(run_name);
  if (!records.empty()) out.write(records.filename(), "");
  NativeRun run;
  Command command = command_of(request, folder / run_name, records);
  std::string heard;
  if (request.listener) {
    command.hears = [&](std::string_view line) {
      heard.append(line).append("\n");
      return request.listener->answer(line);
    };
  }
  const Stopwatch stopwatch;
  run.outcome = mjcourse::run(command);
  run.seconds = stopwatch.seconds();
  Trace all = compiling_;
  trace_run(run.outcome, folder, context_.root, all);
  context_.trace.add(all);
  run.files =
      program_files(*compiled_, run.outcome, context_.compiler.include_folders(), context_.root);
  if (request.listener) {
    run.records = std::move(heard);
  } else if (fs::file_size(records) <= kMostRecords) {
    run.records = DiskFiles(folder).read(records.filename()).value();
  }
  const bool repeats = compiled_->raw.empty() && run.outcome.end == Outcome::End::exited &&
                       run.outcome.code == request.exit_code;
  if (repeats && run.records && request.is_kept) {
    context_.store.keep(recipe_of(request), all, begin_, bytes_of(run));
  }
  return run;
}

}  // namespace mjcourse
