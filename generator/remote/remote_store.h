// RemoteStore: a Store behind a server that speaks Bazel's HTTP cache protocol.
//
// `GET`, `HEAD` and `PUT` of `cas/HASH`, and of `ac/HASH` for all else that has a name
// (https://bazel.build/remote/caching#http-caching). Nothing that a server says is believed: bytes
// must have their hash, and other entries their seal (base/store_entry.h) and, where keys are
// trusted, a signature. Nothing that it does
// stops the work: what it does not give is a miss, and one that costs time is asked no more.
// Tested by tests/store/remote_faults.mjs.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "base/store.h"
#include "remote/http_client.h"
#include "remote/server.h"

namespace mjcourse {

class RemoteStore : public Store {
 public:
  // `program` is mjcourse-net. Throws std::system_error where it cannot be started.
  RemoteStore(const std::filesystem::path& program, const Server& server, bool read_only);

  std::optional<Stored> find(const std::string& name) override;
  // Nothing is signed that is from elsewhere and that nobody vouches for.
  bool keep(const std::string& name, std::string_view bytes, const Origin& origin) override;

  bool is_written() const;

  struct Traffic {
    std::size_t found = 0, missed = 0, put = 0;  // entries
    std::uint64_t received = 0, sent = 0;        // bytes of their contents
    double waited = 0;                           // s, of all threads together
  };
  Traffic traffic() const;
  // What the user should know, each a sentence: a server that is down, a damaged entry.
  std::vector<std::string> notes() const;

 private:
  struct Read {
    std::optional<std::string> bytes = {};
    bool is_former = false;  // another version of the generator put it
    bool is_signed = true;   // as it must be
    Origin origin = {};
  };
  enum class Doubt { damaged, unsigned_ };

  Read read_entry(const std::string& name, std::string_view content) const;
  std::string entry_of(const std::string& sealed) const;
  void note_once(Doubt doubt, const std::string& path);
  HttpAnswer ask(std::string_view verb, const std::string& path, std::string_view content = {});
  void judge(std::string_view verb, const HttpAnswer& answer, double seconds);
  void stop(bool reads, const std::string& why);

  Server server_;
  Trust trust_;
  HttpClient client_;
  mutable std::mutex mutex_;
  bool reads_ = true, writes_;
  bool was_damaged_ = false, was_unsigned_ = false;  // and was noted
  int failures_ = 0, failed_puts_ = 0;               // one after the other
  double wasted_ = 0;                                // s, waiting for what did not come
  int answers_ = 0;                                  // that were right
  Traffic traffic_;
  std::vector<std::string> notes_;
  std::string stopped_;  // the note on what is not asked any more: all of it, or what is put
};

}  // namespace mjcourse
