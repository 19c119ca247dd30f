// PreviewServer: a Preview over HTTP, for browsers on this machine alone.
//
// It listens on 127.0.0.1 and answers no request that asks for another host or comes from another
// origin, so no page of the web can read a course, whatever name it gives to this machine.
// Tested by tests/preview/slow-clients.mjs.
#pragma once

#include <memory>
#include <string>

#include "preview/preview.h"

namespace mjcourse {

class PreviewServer {
 public:
  // Takes `port`; without one, the first that is free from 8000 on. Throws std::runtime_error where
  // that is taken.
  PreviewServer(Preview& preview, std::optional<int> port);
  ~PreviewServer();
  PreviewServer(const PreviewServer&) = delete;
  PreviewServer& operator=(const PreviewServer&) = delete;

  int port() const;
  std::string address() const;  // "http://127.0.0.1:8000/"

  // Answers until stop().
  void run();
  void stop();

 private:
  class Http;
  std::unique_ptr<Http> http_;
};

}  // namespace mjcourse
