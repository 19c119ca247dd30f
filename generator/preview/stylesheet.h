// Stylesheet: the site's one stylesheet, bundled anew while its sources are being edited.
//
// Bundling is the site's own (site/bundle/restyle.mjs), by a Node process that stays: to start one
// for each save would take longer than all else.
// Tested by tests/preview/styles.mjs.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "base/temporary_folder.h"
#include "process/child_process.h"
#include "report/diagnostic.h"

namespace mjcourse {

class Stylesheet {
 public:
  // `site` is the folder of the site's sources; nothing is bundled until it is asked to.
  explicit Stylesheet(std::filesystem::path site) : site_(std::move(site)) {}
  ~Stylesheet();
  Stylesheet(const Stylesheet&) = delete;
  Stylesheet& operator=(const Stylesheet&) = delete;

  struct Bundle {
    std::string path;  // below the site's root: "assets/site-1A2B3C4D.css"; empty after a mistake
    Diagnostics mistakes;
  };
  // Begins what makes the first bundle as quick as the others; waits for nothing.
  void prepare() { start(); }

  // Takes some milliseconds; without prepare(), or just after it, some seconds.
  Bundle renew();

  // Where the files of the bundles are.
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  bool start();
  std::optional<std::string> ask();

  std::filesystem::path site_;
  TemporaryFolder folder_;
  pid_t process_ = -1;
  Descriptor to_;
  std::FILE* from_ = nullptr;
};

}  // namespace mjcourse
