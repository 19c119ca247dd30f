// OnDemandPages: the pages of a course as it is being edited, each made when somebody asks for it.
//
// Enter with show() for each snapshot and page() for each page. Script engines serve one thread, so
// pages are made on a thread of their own, which all others wait for. A page that cannot be made
// any more, as its lesson is gone or its template broken, stays as it was last.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "page/blocks/themed_assets.h"
#include "page/site_pages.h"
#include "preview/memory_site.h"
#include "session/snapshot.h"

namespace mjcourse {

class OnDemandPages {
 public:
  // `root` is the course's folder, `assets` the folder that site/bundle/build.mjs filled,
  // `templates` one with other templates, or empty; and `program` is the generator's own file,
  // which renders these.
  OnDemandPages(std::filesystem::path root, std::filesystem::path assets,
                const std::filesystem::path& templates, std::filesystem::path program);
  ~OnDemandPages();
  OnDemandPages(const OnDemandPages&) = delete;
  OnDemandPages& operator=(const OnDemandPages&) = delete;

  // From here on pages are made of this. All from any thread.
  void show(SnapshotPtr snapshot);
  // The templates were edited.
  void renew_templates();

  struct Page {
    std::string html;    // empty where there is no such page, and never was, or no snapshot yet
    std::string source;  // the lesson's file, where it is a lesson's page
    std::optional<Diagnostic> fault;            // why it could not be made: this is the last one
    std::map<std::string, std::string> hashes;  // of pictures that keep their addresses
    SnapshotPtr snapshot;
  };
  Page page(const std::string& path);

  // A file of the site that is no page.
  std::optional<std::string> file(const std::string& path);

 private:
  // What was made of one snapshot.
  struct Made {
    SnapshotPtr snapshot;
    MemorySite site;
    std::unique_ptr<SitePages> pages;
    std::set<std::size_t> lessons;  // that were made
    bool others = false;
  };

  void work();
  void do_on_thread(const std::function<void()>& work);
  bool has_snapshot();
  Made& newest();
  void make(const std::string& path);
  void make_lesson(Made& made, std::size_t index);
  void make_others(Made& made);

  std::filesystem::path root_, assets_folder_, program_;
  ThemedAssets assets_;
  std::mutex mutex_;
  std::condition_variable woken_;
  std::deque<std::function<void()>> wanted_;
  SnapshotPtr snapshot_;
  bool stale_templates_ = false, stopped_ = false;
  // Of that thread alone.
  std::unique_ptr<Made> made_;
  std::unique_ptr<Made> old_;  // taken apart when nobody waits any more
  std::unique_ptr<PageEngines> engines_;
  std::map<std::string, Page> last_;  // by path: as they were when they could be made
  std::jthread thread_;               // last: it uses the rest
};

}  // namespace mjcourse
