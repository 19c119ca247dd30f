// Enter here: a course, shown in the browser while it is being written.
//
//   files ──FolderWatch──▶ LiveSession ──Snapshot──▶ OnDemandPages ──▶ PreviewServer ──▶ browser
//
// Each save becomes a new version; the pages that are open hear of it, ask for what they show, and
// put the parts in place that are others now (site/browser/preview/).
// Tested by tests/preview/edits.mjs.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "preview/on_demand_pages.h"
#include "preview/sent_pages.h"
#include "preview/stylesheet.h"
#include "session/folder_watch.h"
#include "session/live_session.h"

namespace mjcourse {

struct PreviewSetup {
  EvaluationSettings settings;   // of the course
  std::filesystem::path assets;  // the folder that site/bundle/build.mjs filled
  std::filesystem::path site;    // its sources, where they are being edited too; else empty
  // How an editor is told to open a file: "vscode://file/{file}:{line}:{column}".
  std::string link;
};

class Preview {
 public:
  // `tell` gets each snapshot, for the terminal. Throws what FolderWatch throws.
  Preview(const PreviewSetup& setup, std::function<void(const Snapshot&)> tell);
  ~Preview();
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  // All from any thread.

  // Waits until the version is another than `known`, at most so long; gives the present one.
  std::size_t wait(std::size_t known, std::chrono::milliseconds at_most);

  // The page `path` as a browser gets it, with the script that keeps it up to date.
  struct Answer {
    std::string html;
    bool found = false;
  };
  Answer page(const std::string& path);
  // What has become of the page `path`, of which the browser has the form whose hash is `known`, in
  // the stylesheet `worn`: site/browser/preview/state.ts has its shape.
  std::string state(const std::string& path, const std::string& known, const std::string& worn);
  // Any other file.
  std::optional<std::string> file(const std::string& path);

 private:
  void watch(const std::stop_token& stop);
  void restyle();
  void next_version();
  std::string newest_css() const;
  std::string styled(std::string html) const;

  const PreviewSetup setup_;
  std::string built_css_;  // path of the stylesheet that pages name
  FolderWatch folders_;
  OnDemandPages pages_;
  SentPages sent_;
  std::optional<Stylesheet> stylesheet_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t version_ = 0;
  Stylesheet::Bundle styles_;
  std::optional<Diagnostic> unwatched_;
  std::unique_ptr<LiveSession> session_;
  std::jthread watcher_;  // last: it uses the rest
};

}  // namespace mjcourse
