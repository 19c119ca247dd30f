// LiveSession: a course, kept evaluated while it is being edited.
//
// Enter with changed() after each save. First comes a snapshot of what is known at once: the new
// text, with results that were kept, and former ones in the place of those that have to be worked
// out. These are worked out in the background, and further snapshots follow as they come. A newer
// save ends the work of the older one.
//
// To look which results were kept takes a moment, and more of it the larger the course is. Where
// nothing but text was edited, a caller that wants guesses gets one before that, with all former
// results; where programs were edited, too, it takes the place of that look.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "course/lesson_cache.h"
#include "evaluate/progress.h"
#include "session/snapshot.h"

namespace mjcourse {

class LiveSession {
 public:
  // `tell` gets each snapshot as it comes, on a thread of the session's; it must not wait for long.
  // All must outlive this. The first snapshot comes by itself. Lessons are read from `lessons`, in
  // which there may be some that nobody has saved yet; what they name is read from the disk.
  LiveSession(EvaluationSettings settings, std::shared_ptr<const Files> lessons,
              std::function<void(SnapshotPtr)> tell, bool wants_guesses = false);
  // Ends all work.
  ~LiveSession();
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;

  // From any thread.
  void changed();

 private:
  struct Job;

  void run();
  // All that is known without working; where `whole`, all that is true, by working for it.
  // What is open in `former` comes first.
  SnapshotPtr snapshot(const SnapshotPtr& former, bool whole, Progress& progress) const;
  SnapshotPtr look(const SnapshotPtr& former) const;
  // Null where more than text was edited.
  SnapshotPtr guess(const SnapshotPtr& former) const;
  std::shared_ptr<Snapshot> begin() const;
  // Works out what is open in `last`, until that is done or something else is wanted; gives the
  // last snapshot that it told.
  SnapshotPtr work(SnapshotPtr last);
  void do_job(Job& job);
  void wake(bool& why);
  // The first program that is edited shall not wait for more than itself.
  void warm_up_for(const SnapshotPtr& snapshot);

  EvaluationSettings settings_;
  std::shared_ptr<const Files> lessons_;
  std::shared_ptr<LessonCache> lesson_cache_ = std::make_shared<LessonCache>();
  std::function<void(SnapshotPtr)> tell_;
  bool wants_guesses_;
  std::mutex mutex_;
  std::condition_variable woken_;
  bool changed_ = true, stopped_ = false;
  std::chrono::steady_clock::time_point changed_at_ = std::chrono::steady_clock::now();
  std::jthread warmer_;
  std::jthread worker_;
  std::jthread thread_;  // last: it uses the rest
};

}  // namespace mjcourse
