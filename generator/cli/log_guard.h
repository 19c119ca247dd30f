// What we print, in the log of a machine that builds: there a line may be a command.
//
// GitHub's runner takes a line that begins with `::`, behind whatever blanks, and `##[` anywhere;
// the one of Azure takes `##vso[`. What a program printed, what a file is called and what a lesson
// says stands in our messages, so none of these leaves us as it is: a backslash stands in it.
#pragma once

#include <iostream>
#include <memory>
#include <streambuf>
#include <string>

namespace mjcourse {

// Passes on what it is given, with no command in it.
class PlainLog : public std::streambuf {
 public:
  explicit PlainLog(std::streambuf& to) : to_(to) {}

 protected:
  int_type overflow(int_type given) override;
  int sync() override { return to_.pubsync(); }

 private:
  enum class At { begin, inside, hash, command };

  std::streambuf& to_;
  At at_ = At::begin;
};

// For as long as it lives, std::cerr is such a log, and std::cout where people read that; where no
// such machine runs us, nothing is changed.
class LogGuard {
 public:
  explicit LogGuard(bool people_read_out);
  ~LogGuard();
  LogGuard(const LogGuard&) = delete;
  LogGuard& operator=(const LogGuard&) = delete;

 private:
  std::unique_ptr<PlainLog> out_log_, err_log_;
  std::streambuf* out_ = nullptr;
  std::streambuf* err_ = nullptr;
};

}  // namespace mjcourse
