// SentPages: the pages that browsers have, so that they need only be sent what has changed.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <string>

namespace mjcourse {

class SentPages {
 public:
  // Gives a hash of the page, by which find() gives it again while it is one of the newest.
  std::string keep(const std::string& html);
  std::optional<std::string> find(const std::string& hash) const;

 private:
  struct Page {
    std::string hash, html;
  };
  mutable std::mutex mutex_;
  std::deque<Page> pages_;  // the newest last
};

}  // namespace mjcourse
