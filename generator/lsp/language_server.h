// LanguageServer: a course in an editor, by the Language Server Protocol: what is wrong with the
// lessons as they are being typed, what could be written, and what is known of what stands there.
//
// Enter with run(). One thread takes the editor's messages and answers them. A session evaluates
// the course behind it (session/live_session.h), with the open documents for the saved ones, once
// nobody has typed for a moment; so typing never waits. Bytes that are no message, and questions
// that we do not know, are refused, and the next message is taken.
// Tested by tests/lsp/hostile.mjs.
#pragma once

#include <iosfwd>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "evaluate/evaluate.h"
#include "lsp/connection.h"
#include "lsp/editor_session.h"

namespace mjcourse {

class LanguageServer {
 public:
  struct Setup {
    EvaluationSettings settings;  // its root is the course, unless the editor names one
    bool root_named = false;      // its author named it: the editor's does not count
    std::string version;
  };

  // `out` must outlive this.
  LanguageServer(Setup setup, std::ostream& out);

  // Until the editor says that it is over, or says nothing any more. Gives false where it had not
  // said before that it would be.
  bool run(std::istream& in);

 private:
  void take(const std::string& body);
  void ask(const nlohmann::json& id, const std::string& method, const nlohmann::json& params);
  void tell(const std::string& method, const nlohmann::json& params);
  nlohmann::json initialize(const nlohmann::json& params);

  Setup setup_;
  Connection connection_;
  std::unique_ptr<EditorSession> session_;  // null before `initialize`
  bool shut_down_ = false, over_ = false;
};

}  // namespace mjcourse
