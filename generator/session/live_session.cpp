#include "session/live_session.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iterator>
#include <set>
#include <stop_token>
#include <string>
#include <utility>

#include "base/cancellation.h"
#include "base/stopwatch.h"
#include "evaluate/warm_up.h"
#include "session/examine.h"
#include "session/former_results.h"

namespace mjcourse {
namespace {

// What is worked out of a file sooner after it was saved is not kept (cache/fingerprints.h).
constexpr std::chrono::milliseconds kFresh{15};

// A session that shows a guess has the processor for itself so long.
constexpr std::chrono::milliseconds kShowing{40};

// What is found out last is soon followed by all there is to know.
constexpr std::chrono::milliseconds kLast{100};

// What work found wrong that is done again now may still be wrong: it stays until that is known.
void keep_former(const Diagnostics& former, Diagnostics& diagnostics) {
  for (const Diagnostic& old : former) {
    const bool known = std::ranges::any_of(diagnostics, [&](const Diagnostic& one) {
      return one.id == old.id && one.message == old.message && one.place.file == old.place.file;
    });
    if (!known) diagnostics.push_back(old);
  }
}

Blocks open_blocks(const Snapshot& snapshot) {
  Blocks open;
  if (!snapshot.evaluation) return open;
  for (const Lesson* page : snapshot.course.pages()) {
    for (const std::size_t block : snapshot.evaluation->results_of(*page).open) {
      open.emplace(page->source->path(), block);
    }
  }
  return open;
}

// Tells when something was worked out that nobody had kept.
class Listener : public Progress {
 public:
  explicit Listener(std::function<void()> tell = {}) : tell_(std::move(tell)) {}
  void plan(std::size_t) override {}
  void begin(const std::string& what) override {
    const std::lock_guard lock(mutex_);
    working_.insert(what);
  }
  void end(const std::string& what) override {
    const std::lock_guard lock(mutex_);
    const auto known = working_.find(what);
    if (known == working_.end()) return;
    working_.erase(known);
    if (tell_) tell_();
  }

 private:
  std::function<void()> tell_;
  std::mutex mutex_;
  std::multiset<std::string> working_;
};

}  // namespace

// What a worker does for one save. All but `stop` is guarded by the session's mutex.
struct LiveSession::Job {
  std::stop_source stop;
  std::chrono::steady_clock::time_point begin;
  bool progressed = false, done = false;
  SnapshotPtr last, whole;  // where it began, and what came of it
};

LiveSession::LiveSession(EvaluationSettings settings, std::shared_ptr<const Files> lessons,
                         std::function<void(SnapshotPtr)> tell, bool wants_guesses)
    : settings_(std::move(settings)),
      lessons_(std::move(lessons)),
      tell_(std::move(tell)),
      wants_guesses_(wants_guesses),
      thread_([this] { run(); }) {}

LiveSession::~LiveSession() {
  wake(stopped_);
}

void LiveSession::changed() {
  const std::lock_guard lock(mutex_);
  changed_at_ = std::chrono::steady_clock::now();
  changed_ = true;
  woken_.notify_all();
}

void LiveSession::wake(bool& why) {
  const std::lock_guard lock(mutex_);
  why = true;
  woken_.notify_all();
}

// Each has a course of its own: a page may just be made of the one before.
std::shared_ptr<Snapshot> LiveSession::begin() const {
  return {new Snapshot, [cache = lesson_cache_](Snapshot* old) {
            cache->give_back(old->course);
            delete old;
          }};
}

SnapshotPtr LiveSession::snapshot(const SnapshotPtr& former, bool whole, Progress& progress) const {
  const std::shared_ptr<Snapshot> made = begin();
  const FormerResults results(whole ? nullptr : former);
  try {
    Diagnostics reading;
    if (auto course =
            read_course(*lessons_, reading, settings_.threads, kMostLoaded, lesson_cache_.get())) {
      made->readable = true;
      made->course = *std::move(course);
      EvaluationSettings settings = settings_;
      if (whole) {
        settings.first = open_blocks(*former);
      } else {
        settings.stand_in = [&](const Lesson& lesson, std::size_t block) {
          return results.find(lesson, block);
        };
      }
      made->evaluation =
          std::make_shared<const Evaluation>(examine(made->course, settings, progress, reading));
      const Diagnostics& all = made->evaluation->diagnostics;
      made->of_work.assign(all.begin() + static_cast<std::ptrdiff_t>(reading.size()), all.end());
      if (made->evaluation->open && former) keep_former(former->of_work, made->of_work);
    }
    made->diagnostics = std::move(reading);
  } catch (const std::exception& error) {
    // What is known of a course must be of all its lessons, so nothing is known of none.
    lesson_cache_->give_back(made->course);
    *made = Snapshot();
    made->of_work.push_back(error_at({}, "E-preview", error.what()));
  }
  made->diagnostics.insert(made->diagnostics.end(), made->of_work.begin(), made->of_work.end());
  sort_by_place(made->diagnostics);
  return made;
}

SnapshotPtr LiveSession::look(const SnapshotPtr& former) const {
  Listener nobody;
  return snapshot(former, false, nobody);
}

SnapshotPtr LiveSession::guess(const SnapshotPtr& former) const {
  if (!wants_guesses_ || !former) return nullptr;
  const std::shared_ptr<Snapshot> made = begin();
  try {
    auto course = read_course(*lessons_, made->diagnostics, settings_.threads, kMostLoaded,
                              lesson_cache_.get());
    if (!course) return nullptr;
    made->evaluation = former_evaluation(*former, *course);
    if (!made->evaluation) return nullptr;
    made->course = *std::move(course);
  } catch (const std::exception&) {
    return nullptr;  // the look tells why
  }
  made->readable = made->guessed = true;
  made->of_work = former->of_work;
  std::ranges::copy(made->of_work, std::back_inserter(made->diagnostics));
  sort_by_place(made->diagnostics);
  return made;
}

void LiveSession::do_job(Job& job) {
  const Cancellable cancellable(job.stop.get_token());
  Listener listener([&] { wake(job.progressed); });
  std::this_thread::sleep_until(job.begin);
  try {
    SnapshotPtr whole = snapshot(job.last, true, listener);
    const std::lock_guard lock(mutex_);
    job.whole = std::move(whole);
    job.done = true;
    woken_.notify_all();
  } catch (const Cancelled&) {
    // The caller that cancelled it is not waiting.
  }
}

SnapshotPtr LiveSession::work(SnapshotPtr last) {
  const auto job = std::make_shared<Job>();
  {
    const std::lock_guard lock(mutex_);
    job->begin = changed_at_ + kFresh;
    job->last = last;
  }
  // What is no longer wanted may take a moment to end.
  worker_ = std::jthread([this, job, before = std::move(worker_)]() mutable {
    if (before.joinable()) before.join();
    do_job(*job);
  });
  std::unique_lock lock(mutex_);
  const auto is_over = [&] { return changed_ || stopped_ || job->done; };
  for (;;) {
    woken_.wait(lock, [&] { return is_over() || job->progressed; });
    if (changed_ || stopped_) {
      job->stop.request_stop();
      return last;
    }
    if (job->done) {
      lock.unlock();
      tell_(job->whole);
      return job->whole;
    }
    job->progressed = false;
    if (woken_.wait_for(lock, kLast, is_over)) continue;
    lock.unlock();
    const Stopwatch stopwatch;
    last = look(last);
    tell_(last);
    if (!last->evaluation->open) return last;  // what the worker finds is the same
    lock.lock();
    // Looking takes time from the work.
    woken_.wait_for(lock, 3 * std::chrono::duration<double>(stopwatch.seconds()), is_over);
  }
}

void LiveSession::warm_up_for(const SnapshotPtr& snapshot) {
  warmer_ = std::jthread([this, snapshot](const std::stop_token& stop) {
    const Cancellable cancellable(stop);
    try {
      warm_up(snapshot->course, settings_);
    } catch (const Cancelled&) {
      // The session ends.
    } catch (const std::exception&) {
      // The block that needs it tells why.
    }
  });
}

void LiveSession::run() {
  SnapshotPtr last;
  bool warm = false;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      woken_.wait(lock, [this] { return changed_ || stopped_; });
      if (stopped_) return;
      changed_ = false;
    }
    const SnapshotPtr guessed = guess(last);
    last = guessed ? guessed : look(last);
    tell_(last);
    if (guessed && !last->evaluation->open) {
      std::unique_lock lock(mutex_);
      const auto is_over = [this] { return changed_ || stopped_; };
      if (woken_.wait_for(lock, kShowing, is_over)) continue;
      lock.unlock();
      last = look(last);
      tell_(last);
    }
    if (last->evaluation->open) last = work(std::move(last));
    if (!warm && last->readable) {
      warm_up_for(last);
      warm = true;
    }
  }
}

}  // namespace mjcourse
