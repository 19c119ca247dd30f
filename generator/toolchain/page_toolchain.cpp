#include "toolchain/page_toolchain.h"

#include <array>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "base/files.h"
#include "base/sha256.h"
#include "process/open_to_all.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Of what has no version of its own, the engine and who runs it; "" where they are not there. A
// piece at a time, as new memory for megabytes takes longer than their hash.
std::string hash_of_small_files(const fs::path& folder) {
  Sha256 hash;
  std::array<char, 1 << 16> piece;
  for (const char* name : {"run.mjs", "engine/engine.mjs", "engine/engine.wasm"}) {
    std::ifstream file(folder / name, std::ios::binary);
    if (!file) return "";
    do {
      file.read(piece.data(), piece.size());
      hash.add({piece.data(), static_cast<std::size_t>(file.gcount())});
    } while (file);
  }
  return hash.hex();
}

}  // namespace

std::unique_ptr<PageToolchain> PageToolchain::find(const fs::path& folder) {
  if (folder.empty()) return nullptr;
  const auto compiler = read_file(folder / "version");
  const std::string others = hash_of_small_files(folder);
  if (!compiler || others.empty()) return nullptr;
  if (!fs::exists(folder / "node") || !fs::exists(folder / "header.pch")) return nullptr;
  std::string version = compiler->substr(0, compiler->find('\n')) + "-" + others;
  return std::make_unique<PageToolchain>(fs::absolute(folder), std::move(version));
}

PageToolchain::PageToolchain(fs::path folder, std::string version)
    : folder_(std::move(folder)), version_(std::move(version)) {}

Command PageToolchain::command(const fs::path& folder) const {
  Command command;
  command.arguments = {folder_ / "node", folder_ / "run.mjs", folder_, folder_ / "engine"};
  // The tests' long mode compares the objects of all programs; otherwise it is those of some.
  if (std::getenv("MJCOURSE_COMPARE_ALL_OBJECTS") != nullptr) {
    command.arguments.emplace_back("--compare-all");
  }
  command.folder = folder;
  // Node would look for the system's settings, which the sandbox keeps from it.
  command.environment = {"OPENSSL_CONF=/dev/null"};
  Sandbox sandbox;
  sandbox.read = {folder_};
  sandbox.write = {folder};
  sandbox.reads_all = !can_be_reached_by_all(folder) || !can_be_read_by_all(folder_);
  // V8 reserves far more than it takes.
  sandbox.processes = sandbox.reserves = true;
  sandbox.open_files = 256;
  command.sandbox = std::move(sandbox);
  return command;
}

}  // namespace mjcourse
