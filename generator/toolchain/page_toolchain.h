// PageToolchain: the compiler and the engine of a reader's page, for the build to run programs with
// as the page does.
//
// Enter with find(). The assets have them in cpp/ where they could be made: the compiler as
// WebAssembly, headers and libraries, compiled and as they are, the engine, and the Node that runs
// all of it. PageProcess (page_process.h) asks for programs.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "process/subprocess.h"

namespace mjcourse {

class PageToolchain {
 public:
  // In `folder`, the assets' cpp/; null where it was not made.
  static std::unique_ptr<PageToolchain> find(const std::filesystem::path& folder);

  PageToolchain(std::filesystem::path folder, std::string version);

  // Of everything that decides what a program does in a page.
  const std::string& version() const { return version_; }

  // What runs the program that answers, confined to `folder` and its own files.
  Command command(const std::filesystem::path& folder) const;

 private:
  std::filesystem::path folder_;
  std::string version_;
};

}  // namespace mjcourse
