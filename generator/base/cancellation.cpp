#include "base/cancellation.h"

#include <utility>

namespace mjcourse {
namespace {

thread_local std::stop_token of_this_thread;

}  // namespace

Cancellable::Cancellable(std::stop_token token)
    : outer_(std::exchange(of_this_thread, std::move(token))) {}

Cancellable::~Cancellable() {
  of_this_thread = std::move(outer_);
}

std::stop_token cancellation() {
  return of_this_thread;
}

void end_if_cancelled() {
  if (of_this_thread.stop_requested()) throw Cancelled();
}

}  // namespace mjcourse
