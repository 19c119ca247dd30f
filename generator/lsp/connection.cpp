#include "lsp/connection.h"

#include <utility>

#include "lsp/messages.h"

namespace mjcourse {

using nlohmann::json;

void Connection::answer(const json& id, json result) {
  send({{"id", id}, {"result", std::move(result)}});
}

void Connection::refuse(const json& id, Fault fault, const std::string& message) {
  send({{"id", id}, {"error", {{"code", static_cast<int>(fault)}, {"message", message}}}});
}

void Connection::notify(const std::string& method, json params) {
  send({{"method", method}, {"params", std::move(params)}});
}

void Connection::send(json message) {
  message["jsonrpc"] = "2.0";
  const std::string body = message.dump(-1, ' ', false, json::error_handler_t::replace);
  const std::lock_guard lock(mutex_);
  write_message(out_, body);
}

}  // namespace mjcourse
