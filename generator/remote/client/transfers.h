// Transfers: the requests of `mjcourse-net` that are under way, by libcurl.
// Tested by tests/store/remote.mjs.
#pragma once

#include <curl/curl.h>

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "remote/frames.h"

namespace mjcourse {

class Transfers {
 public:
  // `settings` are what the first message has. `connect` gives a connection to a server that is a
  // socket of this machine.
  Transfers(std::string_view settings, std::function<Descriptor()> connect);
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
  static curl_socket_t open_socket(void* transfers, curlsocktype purpose, curl_sockaddr* address);
  void prepare(Transfer& transfer);
  std::string answer_of(const Transfer& transfer, CURLcode result) const;

  std::map<std::string, std::string> settings_;
  std::function<Descriptor()> connect_;
  CURLM* multi_;
  curl_slist* headers_ = nullptr;
  std::size_t taken_at_once_ = 0;  // bytes of answers that are not whole yet
  std::list<Transfer> transfers_;
};

}  // namespace mjcourse
