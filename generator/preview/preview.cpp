#include "preview/preview.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "page/html/site_paths.h"
#include "preview/inside.h"
#include "preview/page_change.h"
#include "report/diagnostic_json.h"
#include "report/terminal.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// `page`: the hash by which the browser asks what has become of it.
std::string script(const std::string& page) {
  return "<script src=\"/.preview/preview.js\" data-page=\"" + page + "\"></script>\n";
}

std::vector<fs::path> watched_folders(const PreviewSetup& setup) {
  std::vector<fs::path> folders;
  for (const char* name : kCourseFolders) folders.push_back(setup.settings.root / name);
  if (!setup.site.empty()) {
    folders.push_back(setup.site / "browser/styles");
    folders.push_back(setup.site / "press/templates");
  }
  return folders;
}

// Where no page can be shown yet, the script is there all the same, and shows one when it can.
std::string no_page(bool readable) {
  const std::string title = readable ? "There is no such page" : "No page can be shown yet";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
         title + "</title>\n" + script("") + "</head>\n<body class=\"no-page\">\n<main>\n<h1>" +
         title +
         "</h1>\n<p>It appears here as soon as there is one. <a href=\"/index.html\">The course’s "
         "home page</a></p>\n</main>\n</body>\n</html>\n";
}

std::string css_of(const fs::path& assets) {
  const auto manifest = DiskFiles(assets).read("manifest.json");
  if (!manifest) throw std::runtime_error("the site's assets are not built: " + manifest.error());
  return json::parse(*manifest).at("site.css");
}

bool is_below(const fs::path& path, const fs::path& folder) {
  return path.string().starts_with(folder.string() + "/") || path == folder;
}

// `here`: it is about the page that is asked for.
json told(const Diagnostic& diagnostic, bool here) {
  json one = json_of(diagnostic);
  one["text"] = format_for_terminal(diagnostic);
  one["here"] = here;
  return one;
}

json told(const std::vector<PageMark>& marks) {
  json all = json::array();
  for (const PageMark& mark : marks) all.push_back({mark.first, mark.last, mark.running});
  return all;
}

json told(const std::optional<PageChange>& change) {
  if (!change) return nullptr;
  return {{"first", change->first}, {"count", change->count}, {"html", change->html}};
}

// What is wrong with the course as a whole is about every page.
bool is_about(const Diagnostic& diagnostic, const std::string& source) {
  const std::string& file = diagnostic.place.file;
  return file.empty() || file == kCoursePath || concerns(diagnostic, source);
}

json drafts_of(const Course& course) {
  json drafts = json::array();
  for (const Lesson& lesson : course.lessons) {
    if (!lesson.front.draft) continue;
    drafts.push_back({{"href", "/" + site_address(page_path(lesson))},
                      {"title", lesson.number + " " + lesson.front.title.text}});
  }
  return drafts;
}

}  // namespace

Preview::Preview(const PreviewSetup& setup, std::function<void(const Snapshot&)> tell)
    : setup_(setup),
      built_css_(css_of(setup.assets)),
      folders_(watched_folders(setup)),
      pages_(setup.settings.root, setup.assets,
             setup.site.empty() ? fs::path() : setup.site / "press/templates",
             setup.settings.worker ? setup.settings.worker->file : fs::path()) {
  if (!setup.site.empty()) stylesheet_.emplace(setup.site);
  session_ = std::make_unique<LiveSession>(
      setup_.settings, std::make_shared<DiskFiles>(setup_.settings.root),
      [this, tell = std::move(tell)](const SnapshotPtr& snapshot) {
        pages_.show(snapshot);
        next_version();
        if (!snapshot->guessed) tell(*snapshot);
      },
      true);
  watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

Preview::~Preview() {
  watcher_ = {};  // it uses the session
}

void Preview::next_version() {
  const std::lock_guard lock(mutex_);
  ++version_;
  changed_.notify_all();
}

std::size_t Preview::wait(std::size_t known, std::chrono::milliseconds at_most) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, at_most, [&] { return version_ != known; });
  return version_;
}

void Preview::restyle() {
  Stylesheet::Bundle bundle = stylesheet_->renew();
  const std::lock_guard lock(mutex_);
  // After a mistake the page stays as it was.
  if (bundle.path.empty()) bundle.path = styles_.path;
  styles_ = std::move(bundle);
}

void Preview::watch(const std::stop_token& stop) {
  if (stylesheet_) stylesheet_->prepare();
  while (!stop.stop_requested()) {
    std::set<fs::path> changed;
    try {
      changed = folders_.wait(stop);
    } catch (const std::exception& error) {
      // A folder that cannot be watched is told of, and the others still are.
      const std::lock_guard lock(mutex_);
      unwatched_ = error_at({}, "E-preview", error.what());
    }
    const auto any = [&](const fs::path& folder) {
      return std::ranges::any_of(changed,
                                 [&](const fs::path& path) { return is_below(path, folder); });
    };
    const fs::path& course = setup_.settings.root;
    const auto is_read = [&](const char* name) { return any(course / name); };
    if (std::ranges::any_of(kCourseFolders, is_read)) session_->changed();
    const bool has_site = !setup_.site.empty();
    const bool styles = has_site && any(setup_.site / "browser/styles");
    const bool pages = any(course / "theme") || (has_site && any(setup_.site / "press/templates"));
    if (styles) restyle();
    if (pages) pages_.renew_templates();
    if (styles || pages) next_version();
  }
}

std::string Preview::newest_css() const {
  const std::lock_guard lock(mutex_);
  return styles_.path.empty() ? built_css_ : styles_.path;
}

// Pages name the stylesheet that was built; one that was edited since stands in for it.
std::string Preview::styled(std::string html) const {
  const std::size_t at = html.find(built_css_);
  if (at != html.npos) html.replace(at, built_css_.size(), newest_css());
  return html;
}

Preview::Answer Preview::page(const std::string& path) {
  const OnDemandPages::Page page = pages_.page(path);
  if (page.html.empty()) return {no_page(page.snapshot && page.snapshot->readable), false};
  std::string html = styled(page.html);
  // Before all other scripts: it must see the page as it came.
  const std::size_t head = html.find("<link rel=\"stylesheet\"");
  html.insert(head == html.npos ? 0 : head, script(sent_.keep(page.html)));
  return {std::move(html), true};
}

std::string Preview::state(const std::string& path, const std::string& known,
                           const std::string& worn) {
  const std::size_t version = wait(0, std::chrono::seconds(0));
  const OnDemandPages::Page page = pages_.page(path);
  json diagnostics = json::array(), drafts = json::array();
  if (page.fault) diagnostics.push_back(told(*page.fault, true));
  {
    const std::lock_guard lock(mutex_);
    if (unwatched_) diagnostics.push_back(told(*unwatched_, true));
    for (const Diagnostic& mistake : styles_.mistakes) diagnostics.push_back(told(mistake, true));
  }
  bool running = false;
  if (page.snapshot) {
    for (const Diagnostic& one : page.snapshot->diagnostics) {
      diagnostics.push_back(told(one, is_about(one, page.source)));
    }
    drafts = drafts_of(page.snapshot->course);
    running = page.snapshot->evaluation->open || page.snapshot->guessed;
  }
  const std::string css = newest_css();
  const std::string hash = sent_.keep(page.html);
  const std::optional<std::string> before = sent_.find(known);
  const auto change = before ? page_change(*before, page.html) : std::nullopt;
  const bool is_known = known == hash || change;
  return json{{"version", version},
              {"running", running},
              {"source", page.source},
              {"diagnostics", std::move(diagnostics)},
              {"drafts", std::move(drafts)},
              {"pictures", page.hashes},
              {"stylesheet", css},
              {"css", worn.empty() || css == worn ? json(nullptr) : json(file(css).value_or(""))},
              {"hash", hash},
              {"change", told(change)},
              {"html", is_known ? json(nullptr) : json(page.html)},
              {"marks", told(marks_of(page.html))},
              {"course", setup_.settings.root.string()},
              {"link", setup_.link}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<std::string> Preview::file(const std::string& path) {
  if (path.starts_with(".preview/")) {
    const fs::path folder = setup_.assets / "preview";
    return read_inside(folder, folder / path.substr(std::string(".preview/").size()));
  }
  // A site that was served here before may have left its worker in the browser; this one ends it.
  if (path == "sw.js") return DiskFiles(setup_.assets).read("preview/sw.js").value();
  if (stylesheet_) {
    if (auto bytes = read_inside(stylesheet_->folder(), stylesheet_->folder() / path)) return bytes;
  }
  return pages_.file(path);
}

}  // namespace mjcourse
