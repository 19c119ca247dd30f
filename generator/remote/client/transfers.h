// Transfers: the requests of `mjcourse-net` that are under way, by libcurl.
// Tested by tests/store/remote.mjs.
#pragma once

#include <curl/curl.h>

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "remote/frames.h"

namespace mjcourse {

class Transfers {
 public:
  // `settings` are those of the first message.
  explicit Transfers(const Message& settings);
  ~Transfers();
  Transfers(const Transfers&) = delete;
  Transfers& operator=(const Transfers&) = delete;

  void begin(Message question);
  // Until something happens. Can `input` be read?
  bool wait(int input);
  // The answers that are whole now, as they are sent.
  std::vector<std::string> finished();

 private:
  struct Transfer;
  void prepare(Transfer& transfer) const;
  std::string answer_of(const Transfer& transfer, CURLcode result) const;

  std::map<std::string, std::string> settings_;
  CURLM* multi_;
  curl_slist* headers_ = nullptr;
  std::size_t taken_at_once_ = 0;  // bytes of answers that are not whole yet
  std::list<Transfer> transfers_;
};

}  // namespace mjcourse
