#include "toolchain/page_toolchain.h"

#include <cstring>
#include <stdexcept>
#include <utility>

#include "base/content_hash.h"
#include "base/files.h"
#include "process/open_to_all.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHeader = "header";
constexpr double kHeaderSeconds = 300;
constexpr std::uint64_t kMostWritten = 1 << 30;  // a header is some ten megabytes

// Of what has no version of its own, the engine and who runs it; "" where they are not there.
std::string hash_of_small_files(const fs::path& folder) {
  std::string bytes;
  for (const char* name : {"run.mjs", "engine/engine.mjs", "engine/engine.wasm"}) {
    const auto file = read_file(folder / name);
    if (!file) return "";
    bytes += *file;
  }
  return content_hash(bytes);
}

}  // namespace

std::unique_ptr<PageToolchain> PageToolchain::find(const fs::path& folder,
                                                   const std::optional<fs::path>& prepared) {
  if (folder.empty()) return nullptr;
  const auto compiler = read_file(folder / "version");
  const std::string others = hash_of_small_files(folder);
  if (!compiler || others.empty() || !fs::exists(folder / "node")) return nullptr;
  std::string version = compiler->substr(0, compiler->find('\n')) + "-" + others;
  return std::make_unique<PageToolchain>(fs::absolute(folder), std::move(version), prepared);
}

PageToolchain::PageToolchain(fs::path folder, std::string version,
                             const std::optional<fs::path>& prepared)
    : folder_(std::move(folder)), version_(std::move(version)), prepared_(prepared) {}

Command PageToolchain::command(const fs::path& folder) {
  const fs::path header = this->header();
  Command command = confined({folder_, folder_ / "engine", header}, folder);
  command.sandbox->read.push_back(header);
  if (!can_be_read_by_all(header)) command.sandbox->reads_all = true;
  return command;
}

Command PageToolchain::confined(std::vector<std::string> arguments, const fs::path& folder) const {
  Command command;
  command.arguments = {folder_ / "node", folder_ / "run.mjs"};
  command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
  command.folder = folder;
  // Node would look for the system's settings, which the sandbox keeps from it.
  command.environment = {"OPENSSL_CONF=/dev/null"};
  Sandbox sandbox;
  sandbox.read = {folder_};
  sandbox.write = {folder};
  sandbox.reads_all = !can_be_reached_by_all(folder) || !can_be_read_by_all(folder_);
  // V8 reserves far more than it takes.
  sandbox.processes = sandbox.reserves = true;
  sandbox.file_bytes = sandbox.folder_bytes = kMostWritten;
  sandbox.open_files = 256;
  command.sandbox = std::move(sandbox);
  return command;
}

fs::path PageToolchain::header() {
  const std::lock_guard lock(mutex_);
  if (!header_.empty()) return header_;
  std::string why;
  if (prepared_.keeps()) {
    using Made = std::optional<PreparedFolders::Made>;
    const auto entry =
        prepared_.get("page\n" + version_, [&](const fs::path&, const fs::path& staging) -> Made {
          why = make_header(staging / kHeader);
          return why.empty() ? Made({true, {}}) : std::nullopt;
        });
    if (entry) return header_ = entry->folder / kHeader;
  }
  if (!own_) own_.emplace();
  const fs::path header = own_->path() / kHeader;
  if (why.empty()) why = make_header(header);
  if (why.empty()) return header_ = header;
  throw std::runtime_error("the page's compiler cannot prepare its headers: " + why);
}

std::string PageToolchain::make_header(const fs::path& header) {
  Command command = confined({"--prepare", folder_, header}, header.parent_path());
  command.seconds = kHeaderSeconds;
  const Outcome outcome = run(command);
  if (outcome.end == Outcome::End::exited && outcome.code == 0 && fs::exists(header)) return "";
  if (outcome.end == Outcome::End::not_started) {
    return command.arguments.front() + ": " + strerror(outcome.code);
  }
  const std::string& said = outcome.refused.empty() ? outcome.err : outcome.refused;
  return said.empty() ? "it ended without a word" : said;
}

}  // namespace mjcourse
