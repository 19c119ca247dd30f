#include "preview/preview_server.h"

#include <arpa/inet.h>
#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace mjcourse {
namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr int kFirstPort = 8000, kLastPort = 8099;
// A browser holds one connection for news, and asks with a few more. Each has a thread of its own,
// so one that says nothing, or reads nothing, holds up no other.
constexpr std::size_t kMostConnections = 512;
// Of these, for news. A browser whose news end asks again, so the oldest give way.
constexpr std::size_t kMostStreams = 64;
// After how long a connection ends that says nothing, or takes nothing of its answer.
constexpr std::time_t kPatience = 5;  // seconds
// Between two signs of life, so that a browser that is gone is noticed.
constexpr std::chrono::seconds kSignOfLife{15};

std::string type_of(const std::string& path) {
  static const std::map<std::string, std::string> types{{".html", "text/html; charset=utf-8"},
                                                        {".css", "text/css; charset=utf-8"},
                                                        {".js", "text/javascript"},
                                                        {".mjs", "text/javascript"},
                                                        {".json", "application/json"},
                                                        {".wasm", "application/wasm"},
                                                        {".svg", "image/svg+xml"},
                                                        {".png", "image/png"},
                                                        {".jpg", "image/jpeg"},
                                                        {".webp", "image/webp"},
                                                        {".mp4", "video/mp4"},
                                                        {".woff2", "font/woff2"},
                                                        {".csv", "text/csv; charset=utf-8"},
                                                        {".xml", "text/xml; charset=utf-8"},
                                                        {".txt", "text/plain; charset=utf-8"},
                                                        {".cpp", "text/plain; charset=utf-8"},
                                                        {".h", "text/plain; charset=utf-8"}};
  const std::size_t dot = path.rfind('.');
  const auto type = dot == path.npos ? types.end() : types.find(path.substr(dot));
  return type == types.end() ? "application/octet-stream" : type->second;
}

// As a provider: what is set as content, the library compresses with all its might, which takes
// longer than everything else.
void give(std::string bytes, const std::string& type, httplib::Response& response) {
  const std::size_t size = bytes.size();
  response.set_content_provider(
      size, type,
      [bytes = std::move(bytes)](std::size_t begin, std::size_t length, httplib::DataSink& sink) {
        return sink.write(bytes.data() + begin, length);
      });
}

// A thread for each connection.
class ConnectionThreads : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> serve) override {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [&] { return running_ < kMostConnections; });
    ++running_;
    std::thread([this, serve = std::move(serve)] {
      serve();
      const std::lock_guard guard(mutex_);
      --running_;
      ended_.notify_all();
    }).detach();
  }

  void shutdown() override {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [&] { return running_ == 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  std::size_t running_ = 0;
};

// Ends all connections of this process at its port `port`: a thread that waits for them waits no
// more.
void end_connections(int port) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", ignored)) {
    const int descriptor = std::stoi(entry.path().filename().string());
    sockaddr_in address{};
    socklen_t size = sizeof address;
    const bool known = getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) == 0;
    if (known && address.sin_family == AF_INET && ntohs(address.sin_port) == port) {
      ::shutdown(descriptor, SHUT_RDWR);
    }
  }
}

}  // namespace

class PreviewServer::Http {
 public:
  Http(Preview& preview, std::optional<int> port) : preview_(preview) {
    server_.new_task_queue = [] { return new ConnectionThreads; };
    server_.set_read_timeout(kPatience);
    server_.set_write_timeout(kPatience);
    // A connection is for one request: what follows that, such as the body of one that is refused,
    // would be read into memory as the next one's first line, without a bound.
    server_.set_keep_alive_max_count(1);
    server_.set_tcp_nodelay(true);
    // The library's own options would let two previews share a port.
    server_.set_socket_options([](int socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    bind(port);
    server_.set_pre_routing_handler([this](const auto& request, auto& response) {
      if (!is_ours(request)) {
        response.status = 403;
        response.set_content("mjcourse preview answers this machine's browser alone\n",
                             "text/plain");
        return httplib::Server::HandlerResponse::Handled;
      }
      if (request.method == "GET" || request.method == "HEAD") {
        return httplib::Server::HandlerResponse::Unhandled;
      }
      // Before its body is read.
      response.status = 405;
      response.set_content("mjcourse preview is only read\n", "text/plain");
      return httplib::Server::HandlerResponse::Handled;
    });
    server_.Get("/.preview/events", [this](const auto&, auto& response) { tell_news(response); });
    server_.Get("/.preview/state", [this](const auto& request, auto& response) {
      give(preview_.state(request.get_param_value("page"), request.get_param_value("known"),
                          request.get_param_value("worn")),
           "application/json", response);
    });
    server_.Get(".*", [this](const auto& request, auto& response) { answer(request, response); });
    server_.set_post_routing_handler([](const auto&, auto& response) {
      response.set_header("Cache-Control", "no-store");
      response.set_header("X-Content-Type-Options", "nosniff");
      response.set_header("Cross-Origin-Resource-Policy", "same-origin");
    });
  }

  int port() const { return port_; }
  void run() { server_.listen_after_bind(); }
  void stop() {
    stopped_ = true;
    server_.stop();
    end_connections(port_);
  }

 private:
  void bind(std::optional<int> port) {
    if (port) {
      port_ = *port;
      if (server_.bind_to_port(kHost, port_)) return;
      throw std::runtime_error("port " + std::to_string(port_) +
                               " is taken; name another, or none, and a free one is found");
    }
    for (port_ = kFirstPort; port_ <= kLastPort; ++port_) {
      if (server_.bind_to_port(kHost, port_)) return;
    }
    port_ = server_.bind_to_any_port(kHost);
    if (port_ < 0) throw std::runtime_error("no port is free");
  }

  bool is_ours(const httplib::Request& request) const {
    const std::string port = ":" + std::to_string(port_);
    const auto known = [&](const std::string& host) {
      return host == kHost + port || host == "localhost" + port;
    };
    const std::string origin = request.get_header_value("Origin");
    const std::string scheme = "http://";
    return known(request.get_header_value("Host")) &&
           (origin.empty() || (origin.starts_with(scheme) && known(origin.substr(scheme.size()))));
  }

  // What a browser knows that is told of news.
  struct Stream {
    std::size_t version = 0;
    std::chrono::steady_clock::time_point spoken;
    std::atomic<bool> given_up = false;
  };

  std::shared_ptr<Stream> new_stream() {
    auto stream = std::make_shared<Stream>();
    const std::lock_guard lock(mutex_);
    std::erase_if(streams_, [](const auto& other) { return other.expired(); });
    streams_.push_back(stream);
    if (streams_.size() <= kMostStreams) return stream;
    if (const auto oldest = streams_.front().lock()) oldest->given_up = true;
    streams_.erase(streams_.begin());
    return stream;
  }

  // Server-sent events: each is the number of a version.
  void tell_news(httplib::Response& response) {
    response.set_chunked_content_provider(
        "text/event-stream", [this, stream = new_stream()](std::size_t, httplib::DataSink& sink) {
          const std::size_t version =
              preview_.wait(stream->version, std::chrono::milliseconds(200));
          if (stopped_ || stream->given_up) return false;
          const auto now = std::chrono::steady_clock::now();
          std::string text;
          if (version != stream->version) {
            text = "data: " + std::to_string(version) + "\n\n";
          } else if (now - stream->spoken > kSignOfLife) {
            text = ": still here\n\n";
          }
          stream->version = version;
          if (text.empty()) return true;
          stream->spoken = now;
          return sink.write(text.data(), text.size());
        });
  }

  void answer(const httplib::Request& request, httplib::Response& response) {
    std::string path = request.path.substr(1);
    if (path.empty() || path.ends_with('/')) path += "index.html";
    if (path.ends_with(".html")) {
      Preview::Answer answer = preview_.page(path);
      response.status = answer.found ? 200 : 404;
      give(std::move(answer.html), type_of(path), response);
      return;
    }
    if (auto bytes = preview_.file(path)) {
      give(*std::move(bytes), type_of(path), response);
    } else {
      response.status = 404;
      response.set_content("not found\n", "text/plain");
    }
  }

  Preview& preview_;
  httplib::Server server_;
  int port_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;  // of the streams
  std::vector<std::weak_ptr<Stream>> streams_;
};

PreviewServer::PreviewServer(Preview& preview, std::optional<int> port)
    : http_(std::make_unique<Http>(preview, port)) {}

PreviewServer::~PreviewServer() = default;

int PreviewServer::port() const {
  return http_->port();
}

std::string PreviewServer::address() const {
  return "http://127.0.0.1:" + std::to_string(port()) + "/";
}

void PreviewServer::run() {
  http_->run();
}

void PreviewServer::stop() {
  http_->stop();
}

}  // namespace mjcourse
