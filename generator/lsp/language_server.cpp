#include "lsp/language_server.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <istream>
#include <map>
#include <utility>

#include "lsp/file_uri.h"
#include "lsp/messages.h"

namespace mjcourse {
namespace {

using nlohmann::json;

const std::map<std::string, json (EditorSession::*)(const json&)>& questions() {
  static const std::map<std::string, json (EditorSession::*)(const json&)> all{
      {"textDocument/completion", &EditorSession::complete},
      {"textDocument/hover", &EditorSession::hover},
      {"textDocument/definition", &EditorSession::define},
      {"textDocument/documentSymbol", &EditorSession::outline},
      {"textDocument/codeAction", &EditorSession::accept}};
  return all;
}

const std::map<std::string, void (EditorSession::*)(const json&)>& events() {
  static const std::map<std::string, void (EditorSession::*)(const json&)> all{
      {"textDocument/didOpen", &EditorSession::open},
      {"textDocument/didChange", &EditorSession::change},
      {"textDocument/didClose", &EditorSession::close}};
  return all;
}

// The folder that the editor has open.
std::optional<std::filesystem::path> root_in(const json& params) {
  const json folders = params.value("workspaceFolders", json());
  if (folders.is_array() && !folders.empty()) {
    return path_of(folders.front().at("uri").get<std::string>());
  }
  const json root = params.value("rootUri", json());
  return root.is_string() ? path_of(root.get<std::string>()) : std::nullopt;
}

// UTF-8 where the editor knows it too; UTF-16 is what all of them know.
Units units_in(const json& params) {
  const json::json_pointer offered("/capabilities/general/positionEncodings");
  const json encodings = params.contains(offered) ? params.at(offered) : json::array();
  const bool knows = encodings.is_array() &&
                     std::find(encodings.begin(), encodings.end(), "utf-8") != encodings.end();
  return knows ? Units::utf8 : Units::utf16;
}

}  // namespace

LanguageServer::LanguageServer(Setup setup, std::ostream& out)
    : setup_(std::move(setup)), connection_(out) {}

bool LanguageServer::run(std::istream& in) {
  while (!over_) {
    const auto body = read_message(in);
    if (!body) break;
    take(*body);
  }
  return shut_down_;
}

void LanguageServer::take(const std::string& body) {
  const json message = parse_message(body);
  if (message.is_discarded()) {
    return connection_.refuse(nullptr, Fault::no_json, "this is not JSON");
  }
  const json id = message.is_object() ? message.value("id", json()) : json();
  const json method = message.is_object() ? message.value("method", json()) : json();
  if (!method.is_string()) {
    // An answer to what we did not ask has no method either.
    if (message.is_object() && (message.contains("result") || message.contains("error"))) return;
    return connection_.refuse(id, Fault::no_request, "this names no method");
  }
  const json params = message.value("params", json::object());
  try {
    if (message.contains("id")) {
      ask(id, method, params);
    } else {
      tell(method, params);
    }
  } catch (const json::exception& error) {
    if (message.contains("id")) connection_.refuse(id, Fault::wrong_parameters, error.what());
  } catch (const std::exception& error) {
    if (message.contains("id")) connection_.refuse(id, Fault::ours, error.what());
  }
}

void LanguageServer::ask(const json& id, const std::string& method, const json& params) {
  if (method == "initialize") {
    if (session_) return connection_.refuse(id, Fault::no_request, "`initialize` was sent before");
    return connection_.answer(id, initialize(params));
  }
  if (!session_) return connection_.refuse(id, Fault::not_initialized, "`initialize` comes first");
  if (shut_down_) return connection_.refuse(id, Fault::no_request, "`shutdown` was sent before");
  if (method == "shutdown") {
    shut_down_ = true;
    return connection_.answer(id, nullptr);
  }
  const auto known = questions().find(method);
  if (known == questions().end()) {
    return connection_.refuse(id, Fault::unknown_method, "there is no method " + method);
  }
  connection_.answer(id, std::invoke(known->second, *session_, params));
}

void LanguageServer::tell(const std::string& method, const json& params) {
  if (method == "exit") over_ = true;
  const auto known = events().find(method);
  if (session_ && known != events().end()) std::invoke(known->second, *session_, params);
}

json LanguageServer::initialize(const json& params) {
  const auto root = setup_.root_named ? std::nullopt : root_in(params);
  if (root) setup_.settings.root = *root;
  const Units units = units_in(params);
  session_ = std::make_unique<EditorSession>(setup_.settings, units, connection_);
  return {{"capabilities",
           {{"positionEncoding", units == Units::utf8 ? "utf-8" : "utf-16"},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}}},
            {"completionProvider",
             {{"triggerCharacters", {"`", "\"", "'", ".", ">", "[", "(", "#", ":", "=", "{"}}}},
            {"hoverProvider", true},
            {"definitionProvider", true},
            {"documentSymbolProvider", true},
            {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}}}},
          {"serverInfo", {{"name", "mjcourse"}, {"version", setup_.version}}}};
}

}  // namespace mjcourse
