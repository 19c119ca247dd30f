#include "cli/log_guard.h"

#include <cstdlib>

#include "base/utf8.h"

namespace mjcourse {
namespace {

bool is_in_log() {
  return std::getenv("GITHUB_ACTIONS") != nullptr || std::getenv("TF_BUILD") != nullptr;
}

}  // namespace

PlainLog::int_type PlainLog::overflow(int_type given) {
  if (traits_type::eq_int_type(given, traits_type::eof())) return traits_type::not_eof(given);
  const char c = traits_type::to_char_type(given);
  // What is no ASCII may be a blank of Unicode's.
  const bool blank = c == ' ' || (c >= '\t' && c <= '\r') || static_cast<unsigned char>(c) >= 0x80;
  const bool starts = at_ == At::begin && c == ':';
  const bool opens = at_ == At::command && c == '[';
  if ((starts || opens) && traits_type::eq_int_type(to_.sputc('\\'), traits_type::eof())) {
    return traits_type::eof();
  }
  if (c == '\n' || c == '\r') {
    at_ = At::begin;
  } else if (c == '#') {
    at_ = at_ == At::hash || at_ == At::command ? At::command : At::hash;
  } else if (at_ == At::command) {
    if (!is_letter(c)) at_ = At::inside;
  } else if (at_ != At::begin || !blank) {
    at_ = At::inside;
  }
  return to_.sputc(c);
}

LogGuard::LogGuard(bool people_read_out) {
  if (!is_in_log()) return;
  err_log_ = std::make_unique<PlainLog>(*std::cerr.rdbuf());
  err_ = std::cerr.rdbuf(err_log_.get());
  if (!people_read_out) return;
  out_log_ = std::make_unique<PlainLog>(*std::cout.rdbuf());
  out_ = std::cout.rdbuf(out_log_.get());
}

LogGuard::~LogGuard() {
  if (err_ != nullptr) std::cerr.rdbuf(err_);
  if (out_ != nullptr) std::cout.rdbuf(out_);
}

}  // namespace mjcourse
