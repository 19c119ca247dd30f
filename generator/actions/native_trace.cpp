#include "actions/native_trace.h"

#include <re2/re2.h>

#include <algorithm>
#include <iterator>

#include "base/files.h"
#include "process/sandbox.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

void trace_files(const std::vector<std::string>& files, const fs::path& folder, Trace& trace) {
  for (const std::string& file : files) {
    if (!file.starts_with(folder.string() + "/")) trace.file(file);
  }
}

// The folder with all in it: a new file there may be read before one that was.
void trace_tree(const fs::path& folder, Trace& trace) {
  trace.file(folder);
  std::error_code none;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none)) {
    trace.file(entry.path());
  }
}

void trace_folders(const fs::path& folder, Trace& trace) {
  trace.file(folder);
  std::error_code none;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none)) {
    if (entry.is_directory()) trace.file(entry.path());
  }
}

bool asks_which_there_are(const fs::path& file) {
  const auto text = read_file(file);
  return !text || text->find("__has_include") != std::string::npos;
}

// May it have files read that the compiler does not list? Assembly can (.incbin), and #embed. Where
// somebody makes such a word of pieces, with ##, it is not seen.
bool may_read_others(const fs::path& file) {
  static const RE2 words(R"(\b(?:asm|__asm|__asm__|__has_embed)\b|(?:#|%:)[ \t]*embed\b)");
  const auto text = read_file(file);
  return !text || RE2::PartialMatch(*text, words);
}

// A header that is added may be read before one that was, `files`, of which `own` are the author's.
// Where the compiler missed one, or the author asks which there are, any may be read.
void trace_include_folders(const std::vector<std::string>& files,
                           const std::vector<std::string>& own, const Compiled& compiled,
                           const IncludeFolders& include_folders, Trace& trace) {
  const bool any = compiled.refused() || std::ranges::any_of(own, asks_which_there_are);
  for (const fs::path& include : include_folders) {
    const fs::path folder = fs::absolute(include).lexically_normal();
    if (any) {
      trace_folders(folder, trace);
    } else {
      trace.headers_in(folder, files);
    }
  }
}

}  // namespace

void trace_compilation(const Compiled& compiled, const fs::path& source,
                       const IncludeFolders& include, const fs::path& root, Trace& trace) {
  if (!compiled.dependencies) return trace.unknown();
  // Mostly the system's headers, which are the same hundreds behind each program.
  std::vector<std::string> files = *compiled.dependencies;
  const std::string folder = source.parent_path();
  std::erase_if(files, [&](const std::string& file) { return is_within(file, folder); });
  trace.files(files);
  for (const WarmObjects::Entry& entry : {compiled.header, compiled.handlers}) {
    if (!entry) continue;
    trace.files(entry->inputs);
    files.insert(files.end(), entry->inputs.begin(), entry->inputs.end());
  }
  std::vector<std::string> own{source};
  const std::string course = fs::absolute(root).lexically_normal();
  std::ranges::copy_if(files, std::back_inserter(own),
                       [&](const std::string& file) { return is_within(file, course); });
  if (std::ranges::any_of(own, may_read_others)) trace.unknown();
  trace_include_folders(files, own, compiled, include, trace);
}

void trace_run(const Outcome& outcome, const fs::path& folder, const fs::path& root, Trace& trace) {
  // A program whose reads the kernel does not tell may have read any model.
  if (!outcome.opened) return trace_tree(fs::absolute(root) / "models", trace);
  trace_files(*outcome.opened, folder, trace);
}

}  // namespace mjcourse
