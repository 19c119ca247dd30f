// PageToolchain: the compiler and the engine of a reader's page, for the build to run programs with
// as the page does.
//
// Enter with find(). The assets have them in cpp/ where they could be made: the compiler as
// WebAssembly, headers and libraries, the engine, and the Node that runs all of it. What programs
// include is compiled once for each version and kept (cache/prepared_folders.h). PageProcess
// (page_process.h) asks for programs.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "cache/prepared_folders.h"
#include "process/subprocess.h"

namespace mjcourse {

class PageToolchain {
 public:
  // In `folder`, the assets' cpp/; null where it was not made. `prepared` is where headers are
  // kept; without it they are made for this process alone.
  static std::unique_ptr<PageToolchain> find(const std::filesystem::path& folder,
                                             const std::optional<std::filesystem::path>& prepared);

  PageToolchain(std::filesystem::path folder, std::string version,
                const std::optional<std::filesystem::path>& prepared);

  // Of everything that decides what a program does in a page.
  const std::string& version() const { return version_; }

  // What runs the program that answers, confined to `folder` and its own files. Makes the header
  // where there is none, which takes some ten seconds; throws std::runtime_error where it cannot.
  Command command(const std::filesystem::path& folder);

 private:
  Command confined(std::vector<std::string> arguments, const std::filesystem::path& folder) const;
  std::filesystem::path header();
  // Why the header is not there; "" where it is.
  std::string make_header(const std::filesystem::path& header);

  std::filesystem::path folder_;
  std::string version_;
  PreparedFolders prepared_;
  std::mutex mutex_;
  std::optional<TemporaryFolder> own_;  // where nothing is kept
  std::filesystem::path header_;
};

}  // namespace mjcourse
