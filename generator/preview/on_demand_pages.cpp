#include "preview/on_demand_pages.h"

#include <algorithm>
#include <exception>
#include <future>
#include <utility>

#include "page/html/site_paths.h"
#include "page/template_process.h"
#include "preview/inside.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// So many bytes of what scripts made of parts of pages that stay the same.
constexpr std::size_t kMemory = 32 << 20;

// The lesson whose page or file `path` is.
std::optional<std::size_t> lesson_of(const Course& course, const std::string& path) {
  const auto owns = [&](const Lesson& lesson) {
    const std::string page = page_path(lesson);
    return path == page || path.starts_with(page.substr(0, page.rfind('.')) + "/") ||
           path.starts_with("labs/" + lesson.number + "-");
  };
  const auto found = std::ranges::find_if(course.lessons, owns);
  if (found == course.lessons.end()) return std::nullopt;
  return static_cast<std::size_t>(found - course.lessons.begin());
}

Diagnostic fault_of(const std::exception& error, const fs::path& root) {
  if (const auto* broken = dynamic_cast<const BrokenTemplate*>(&error)) {
    return template_mistake(broken->error(), DiskFiles(root));
  }
  return error_at({}, "E-preview", error.what());
}

// `edited`: templates that are just being written; empty for none.
std::vector<fs::path> template_folders(const fs::path& root, const fs::path& edited) {
  std::vector<fs::path> folders;
  if (!DiskFiles(root).refusal(kThemeTemplates)) folders.push_back(root / kThemeTemplates);
  if (!edited.empty()) folders.push_back(edited);
  return folders;
}

}  // namespace

OnDemandPages::OnDemandPages(fs::path root, fs::path assets, const fs::path& templates,
                             fs::path program)
    : root_(std::move(root)),
      assets_folder_(std::move(assets)),
      program_(std::move(program)),
      assets_(assets_folder_, template_folders(root_, templates)),
      thread_([this] { work(); }) {}

OnDemandPages::~OnDemandPages() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  woken_.notify_all();
}

void OnDemandPages::work() {
  for (;;) {
    std::function<void()> next;
    {
      std::unique_lock lock(mutex_);
      woken_.wait(lock, [this] { return stopped_ || !wanted_.empty(); });
      if (stopped_ && wanted_.empty()) break;
      next = std::move(wanted_.front());
      wanted_.pop_front();
    }
    next();
    old_.reset();
  }
  // Where they were made.
  made_.reset();
  engines_.reset();
}

void OnDemandPages::do_on_thread(const std::function<void()>& work) {
  std::promise<void> done;
  {
    const std::lock_guard lock(mutex_);
    wanted_.emplace_back([&] {
      work();
      done.set_value();
    });
    woken_.notify_all();
  }
  done.get_future().wait();
}

void OnDemandPages::show(SnapshotPtr snapshot) {
  const std::lock_guard lock(mutex_);
  snapshot_ = std::move(snapshot);
}

void OnDemandPages::renew_templates() {
  const std::lock_guard lock(mutex_);
  stale_templates_ = true;
}

bool OnDemandPages::has_snapshot() {
  const std::lock_guard lock(mutex_);
  return snapshot_ != nullptr;
}

OnDemandPages::Made& OnDemandPages::newest() {
  const std::lock_guard lock(mutex_);
  if (std::exchange(stale_templates_, false)) {
    engines_.reset();
    made_.reset();
  }
  if (!engines_) {
    engines_ = std::make_unique<PageEngines>(
        assets_, kMemory, renderer_of(assets_, program_, fs::absolute(assets_folder_)));
  }
  if (!made_ || made_->snapshot != snapshot_) {
    old_ = std::exchange(made_, std::make_unique<Made>());
    made_->snapshot = snapshot_;
    made_->pages = std::make_unique<SitePages>(snapshot_->course, *snapshot_->evaluation, root_,
                                               assets_, made_->site, true);
  }
  return *made_;
}

void OnDemandPages::make_lesson(Made& made, std::size_t index) {
  if (made.lessons.contains(index)) return;
  made.pages->write_lesson(index, *engines_, true);
  made.lessons.insert(index);
}

void OnDemandPages::make_others(Made& made) {
  if (made.others) return;
  const std::vector<Lesson>& lessons = made.snapshot->course.lessons;
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    if (!lessons[i].front.draft) made.pages->write_lesson(i, *engines_);
  }
  made.pages->write_others(*engines_);
  made.others = true;
}

// So that `path` is there, if it can be.
void OnDemandPages::make(const std::string& path) {
  if (!has_snapshot()) return;
  Made& made = newest();
  if (!made.snapshot->readable) return;
  if (const auto lesson = lesson_of(made.snapshot->course, path)) {
    make_lesson(made, *lesson);
  } else if (!made.site.read(path, root_)) {
    make_others(made);
  }
}

OnDemandPages::Page OnDemandPages::page(const std::string& path) {
  Page page;
  do_on_thread([&] {
    std::optional<Diagnostic> fault;
    try {
      make(path);
    } catch (const std::exception& error) {
      fault = fault_of(error, root_);
    }
    const SnapshotPtr snapshot = made_ ? made_->snapshot : nullptr;
    if (made_ && !fault) {
      if (auto html = made_->site.read(path, root_)) {
        const auto lesson = lesson_of(snapshot->course, path);
        Page& last = last_[path];
        last.html = *std::move(html);
        last.source = lesson ? snapshot->course.lessons[*lesson].source->path() : "";
        last.hashes = made_->site.hashes();
      }
    }
    if (const auto last = last_.find(path); last != last_.end()) page = last->second;
    page.fault = std::move(fault);
    page.snapshot = snapshot;
  });
  return page;
}

std::optional<std::string> OnDemandPages::file(const std::string& path) {
  // What needs no page to be made first.
  if (auto bytes = read_inside(assets_folder_ / "public", assets_folder_ / "public" / path)) {
    return bytes;
  }
  std::optional<std::string> bytes;
  do_on_thread([&] {
    try {
      make(path);
      if (made_) bytes = made_->site.read(path, root_);
    } catch (const std::exception&) {
      // Its page says why.
    }
  });
  return bytes;
}

}  // namespace mjcourse
