#include "remote/remote_store.h"

#include <algorithm>
#include <utility>

#include "base/stopwatch.h"
#include "base/store_entry.h"
#include "remote/action_result.h"

namespace mjcourse {
namespace {

// After so many requests in a row that came to nothing, or so long a wait for those that did, a
// server is asked no more. What is put is counted by itself.
constexpr int kMostFailures = 3;
constexpr double kMostWasted = 12;  // s, of all threads together
// Nor is one whose answers are right, and slower than this, once so long was waited.
constexpr double kSlow = 1, kMostWaited = 30;  // s

// Blobs from this size on are not sent where they are already.
constexpr std::size_t kLarge = 1 << 14;  // bytes

bool is_blob(const std::string& name) {
  return name.starts_with("cas/");
}

std::string path_of(const std::string& name) {
  return is_blob(name) ? name : "ac/" + name.substr(name.find('/') + 1);
}

}  // namespace

RemoteStore::RemoteStore(const std::filesystem::path& program, const Server& server, bool read_only)
    : server_(server), trust_(server.trust()), client_(program, server), writes_(!read_only) {}

void RemoteStore::stop(bool reads, const std::string& why) {
  const bool new_to_us = reads ? reads_ : writes_;
  writes_ = false;
  reads_ = reads_ && !reads;
  if (!new_to_us) return;
  stopped_ = "the shared store at " + server_.address.shown() + " is " +
             (reads ? "not used" : "read and not written") + " from here on: " + why;
}

// What this answer says of the server.
void RemoteStore::judge(std::string_view verb, const HttpAnswer& answer, double seconds) {
  const std::lock_guard lock(mutex_);
  traffic_.waited += seconds;
  const bool puts = verb == "PUT";
  switch (answer.status) {
    case kUnauthorized:
    case kForbidden:
      return stop(!puts, answer.trouble() + "; is MJCOURSE_STORE_TOKEN, or ~/.netrc, right?");
    case kMethodNotAllowed:
    case kNotImplemented:
    case kInsufficientStorage:
      return stop(!puts, answer.trouble() + (puts ? " to what is put there" : ""));
    case kNotFound:
    case kGone:
    case kContentTooLarge:
      (puts ? failed_puts_ : failures_) = 0;
      return;
    default:
      break;
  }
  if (answer.is_good()) {
    (puts ? failed_puts_ : failures_) = 0;
    ++answers_;
    if (traffic_.waited > kMostWaited && traffic_.waited > kSlow * answers_) {
      stop(true, "its answers take longer than a second");
    }
    return;
  }
  wasted_ += seconds;
  // A server that takes nothing, as with a full disk, can still be read.
  if (puts) ++failed_puts_;
  if (!puts || answer.status == 0) ++failures_;
  const bool is_of_no_use = failures_ >= kMostFailures || wasted_ > kMostWasted;
  if (is_of_no_use || failed_puts_ >= kMostFailures) stop(is_of_no_use, answer.trouble());
}

HttpAnswer RemoteStore::ask(std::string_view verb, const std::string& path,
                            std::string_view content) {
  const Stopwatch stopwatch;
  HttpAnswer answer = client_.ask(verb, path, content);
  judge(verb, answer, stopwatch.seconds());
  return answer;
}

bool RemoteStore::is_written() const {
  const std::lock_guard lock(mutex_);
  return writes_;
}

std::optional<Stored> RemoteStore::find(const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    if (!reads_ || !is_store_name(name)) return std::nullopt;
  }
  HttpAnswer answer = ask("GET", path_of(name));
  if (answer.status != kOk) {
    const std::lock_guard lock(mutex_);
    ++traffic_.missed;
    return std::nullopt;
  }
  const std::size_t size = answer.content.size();
  Read read = is_blob(name) ? Read{unsealed(name, std::move(answer.content))}
                            : read_entry(name, answer.content);
  const std::lock_guard lock(mutex_);
  ++(read.bytes ? traffic_.found : traffic_.missed);
  traffic_.received += size;
  if (!read.bytes && !read.is_former)
    note_once(read.is_signed ? Doubt::damaged : Doubt::unsigned_, path_of(name));
  if (!read.bytes) return std::nullopt;
  return Stored{*std::move(read.bytes), std::move(read.origin)};
}

// The first line of an entry has the hash of all of it (base/store_entry.h).
RemoteStore::Read RemoteStore::read_entry(const std::string& name, std::string_view content) const {
  std::optional<Outputs> outputs = outputs_of(content);
  if (!outputs) return {};
  const std::string& entry = outputs->output;
  if (is_of_another_version(entry)) return {.is_former = true};
  const std::string seal = entry.substr(0, entry.find('\n'));
  Origin origin = Origin::unsigned_one();
  for (const std::string& key : trust_.keys) {
    if (!has_signed(key, seal, outputs->error)) continue;
    origin = Origin::signed_by(key);
    break;
  }
  if (!trust_.believes(origin)) return {.is_signed = false};
  return {.bytes = unsealed(name, std::move(outputs->output)), .origin = std::move(origin)};
}

bool RemoteStore::keep(const std::string& name, std::string_view bytes, const Origin& origin) {
  if (!is_written() || !is_store_name(name)) return false;
  if (server_.signing_key && !trust_.vouches_for(origin)) return false;
  const std::string path = path_of(name);
  if (is_blob(name) && bytes.size() >= kLarge && ask("HEAD", path).status == kOk) return true;
  const std::string entry = is_blob(name) ? "" : entry_of(sealed(name, bytes));
  const std::string_view content = is_blob(name) ? bytes : std::string_view(entry);
  if (!ask("PUT", path, content).is_good()) return false;
  const std::lock_guard lock(mutex_);
  ++traffic_.put;
  traffic_.sent += content.size();
  return true;
}

std::string RemoteStore::entry_of(const std::string& sealed) const {
  if (!server_.signing_key) return action_result(sealed);
  return action_result(sealed, server_.signing_key->signature(sealed.substr(0, sealed.find('\n'))));
}

void RemoteStore::note_once(Doubt doubt, const std::string& path) {
  bool& was_noted = doubt == Doubt::damaged ? was_damaged_ : was_unsigned_;
  if (std::exchange(was_noted, true)) return;
  const std::string at = "the shared store at " + server_.address.shown();
  notes_.push_back(
      doubt == Doubt::damaged
          ? at + " gave another content than " + path +
                " was put with; is its address right? Such entries are made again"
          : at + " has entries, such as " + path +
                ", that none of MJCOURSE_STORE_TRUSTED_KEYS has signed; they are made again");
}

RemoteStore::Traffic RemoteStore::traffic() const {
  const std::lock_guard lock(mutex_);
  return traffic_;
}

std::vector<std::string> RemoteStore::notes() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> notes = notes_;
  if (!stopped_.empty()) notes.push_back(stopped_);
  return notes;
}

}  // namespace mjcourse
