// EditorSession: one course in an editor: its open documents, the session that evaluates them, and
// the answers to what is asked about them.
// Tested by tests/lsp/sessions.mjs.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "lsp/asked.h"
#include "lsp/editor_diagnostics.h"
#include "lsp/quiet_moment.h"
#include "session/live_session.h"

namespace mjcourse {

class EditorSession {
 public:
  // `connection` must outlive this.
  EditorSession(EvaluationSettings settings, Units units, Connection& connection);
  ~EditorSession();
  EditorSession(const EditorSession&) = delete;
  EditorSession& operator=(const EditorSession&) = delete;

  // What the editor does; the parameters are the protocol's. They throw nlohmann's exceptions where
  // these are not as they must be. Documents outside of the course are ignored.
  void open(const nlohmann::json& params);
  void change(const nlohmann::json& params);
  void close(const nlohmann::json& params);

  // What it asks; null where nothing is known.
  nlohmann::json complete(const nlohmann::json& params);
  nlohmann::json hover(const nlohmann::json& params);
  nlohmann::json define(const nlohmann::json& params);
  nlohmann::json outline(const nlohmann::json& params);
  nlohmann::json accept(const nlohmann::json& params);

 private:
  void show(const SnapshotPtr& snapshot);
  SnapshotPtr newest();
  std::optional<std::string> name_in(const nlohmann::json& params) const;
  std::optional<Asked> asked(const nlohmann::json& params);
  void watch(const std::stop_token& stop);

  const Units units_;
  std::shared_ptr<OpenDocuments> documents_;
  ModelNames models_;
  const PlotGrammar plots_;
  EditorDiagnostics diagnostics_;
  std::mutex mutex_;
  std::condition_variable shown_;
  SnapshotPtr snapshot_;
  // Each uses those above it.
  LiveSession session_;
  QuietMoment typed_;
  std::jthread watcher_;
};

}  // namespace mjcourse
