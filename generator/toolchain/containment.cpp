#include "toolchain/containment.h"

#include <algorithm>

#include "base/files.h"
#include "process/open_to_all.h"

namespace mjcourse {

namespace fs = std::filesystem;

Sandbox program_sandbox(const fs::path& binary, const fs::path& run, const fs::path& records,
                        const fs::path& root) {
  Sandbox sandbox;
  sandbox.read = {fs::absolute(binary)};
  // A link there would open to the program whatever it leads to.
  if (DiskFiles(root).is_folder("models")) sandbox.read.push_back(fs::absolute(root / "models"));
  sandbox.write = {fs::absolute(run)};
  if (!records.empty()) sandbox.write.push_back(fs::absolute(records));
  sandbox.file_bytes = kMostProgramBytes;
  sandbox.reads_all = !can_be_reached_by_all(binary) || !can_be_reached_by_all(run) ||
                      !can_be_read_by_all(root / "models");
  return sandbox;
}

Sandbox compiler_sandbox(const fs::path& folder, const std::vector<fs::path>& others) {
  Sandbox sandbox;
  for (const fs::path& path : others) sandbox.read.push_back(fs::absolute(path));
  sandbox.write = {fs::absolute(folder)};
  sandbox.reads_all = !can_be_reached_by_all(folder) ||
                      !std::all_of(others.begin(), others.end(), can_be_read_by_all);
  sandbox.processes = true;  // the driver starts the compiler, the assembler and the linker
  sandbox.file_bytes = 1 << 30;
  sandbox.folder_bytes = 1 << 30;
  sandbox.open_files = 256;
  return sandbox;
}

Sandbox commands_sandbox(const fs::path& script, const fs::path& folder) {
  // What they build, they also start.
  Sandbox sandbox =
      compiler_sandbox(folder, {script, folder, fs::path(kInstalledPackages).parent_path()});
  // They know no place of the course, but for the copies that they are given.
  sandbox.reads_all = !can_be_reached_by_all(folder);
  return sandbox;
}

}  // namespace mjcourse
