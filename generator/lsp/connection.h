// Connection: what we say to the editor, from any thread, one message at a time.
#pragma once

#include <iosfwd>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

namespace mjcourse {

// JSON-RPC's numbers for what went wrong, and the protocol's.
enum class Fault {
  no_json = -32700,
  no_request = -32600,
  unknown_method = -32601,
  wrong_parameters = -32602,
  ours = -32603,
  not_initialized = -32002
};

class Connection {
 public:
  // `out` must outlive this.
  explicit Connection(std::ostream& out) : out_(out) {}

  void answer(const nlohmann::json& id, nlohmann::json result);
  void refuse(const nlohmann::json& id, Fault fault, const std::string& message);
  void notify(const std::string& method, nlohmann::json params);

 private:
  void send(nlohmann::json message);

  std::ostream& out_;
  std::mutex mutex_;
};

}  // namespace mjcourse
