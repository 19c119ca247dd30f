// Cancellation: work that is no longer wanted, ended early.
//
// Work that its caller may cancel opens a Cancellable on each of its threads. Whatever takes long
// looks there now and then, and whatever waits for a program looks while it waits.
// Cancelled then goes through all of the work like any exception: programs are killed, folders
// removed, nothing half done is kept.
#pragma once

#include <stop_token>

namespace mjcourse {

struct Cancelled {};

// While this lives, the work of the present thread ends when `token` says so.
class Cancellable {
 public:
  explicit Cancellable(std::stop_token token);
  ~Cancellable();
  Cancellable(const Cancellable&) = delete;
  Cancellable& operator=(const Cancellable&) = delete;

 private:
  std::stop_token outer_;
};

// Of the present thread's work, to be given to others that do a part of it.
std::stop_token cancellation();
// Throws Cancelled where the present thread's work is no longer wanted.
void end_if_cancelled();

}  // namespace mjcourse
