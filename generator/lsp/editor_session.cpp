#include "lsp/editor_session.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "lsp/accept_action.h"
#include "lsp/completion.h"
#include "lsp/definition.h"
#include "lsp/hover.h"
#include "lsp/outline.h"
#include "session/folder_watch.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// Between two keys of an author who writes without a pause.
constexpr std::chrono::milliseconds kQuiet{250};
// Reading a course takes no longer, and only an editor that asks at once has to wait for it.
constexpr std::chrono::seconds kFirstLook{10};

// An editor may ask for actions of another kind alone, as for those to be done on saving.
bool wants_quick_fixes(const json& params) {
  const json context = params.value("context", json::object());
  const json only = context.is_object() ? context.value("only", json()) : json();
  return !only.is_array() || std::ranges::find(only, "quickfix") != only.end();
}

}  // namespace

EditorSession::EditorSession(EvaluationSettings settings, Units units, Connection& connection)
    : units_(units),
      documents_(std::make_shared<OpenDocuments>(settings.root)),
      models_(documents_->root()),
      plots_(read_plot_grammar(settings.assets)),
      diagnostics_(*documents_, connection),
      session_(std::move(settings), documents_,
               [this](const SnapshotPtr& snapshot) { show(snapshot); }),
      typed_(kQuiet, [this] { session_.changed(); }),
      watcher_([this](const std::stop_token& stop) { watch(stop); }) {}

EditorSession::~EditorSession() = default;

void EditorSession::show(const SnapshotPtr& snapshot) {
  {
    const std::lock_guard lock(mutex_);
    snapshot_ = snapshot;
    shown_.notify_all();
  }
  diagnostics_.publish(snapshot->diagnostics, units_);
}

SnapshotPtr EditorSession::newest() {
  std::unique_lock lock(mutex_);
  shown_.wait_for(lock, kFirstLook, [this] { return snapshot_ != nullptr; });
  return snapshot_;
}

// What others save: models, programs, lessons that are not open here.
void EditorSession::watch(const std::stop_token& stop) {
  try {
    const auto& root = documents_->root();
    std::vector<std::filesystem::path> read;
    for (const char* name : kCourseFolders) read.push_back(root / name);
    FolderWatch folders(read);
    while (!folders.wait(stop).empty()) typed_.disturb();
  } catch (const std::system_error&) {
    // The kernel has no more watches to give: what is typed here still counts.
  }
}

std::optional<std::string> EditorSession::name_in(const json& params) const {
  return documents_->name_of(params.at("textDocument").at("uri").get<std::string>());
}

void EditorSession::open(const json& params) {
  const auto name = name_in(params);
  if (!name) return;
  documents_->open(*name, params.at("textDocument").at("text"));
  typed_.disturb();
}

void EditorSession::change(const json& params) {
  const auto name = name_in(params);
  if (!name) return;
  documents_->change(*name, OpenDocuments::read_changes(params.at("contentChanges")), units_);
  typed_.disturb();
}

void EditorSession::close(const json& params) {
  const auto name = name_in(params);
  if (!name) return;
  documents_->close(*name);
  typed_.disturb();
}

std::optional<Asked> EditorSession::asked(const json& params) {
  const auto name = name_in(params);
  const auto text = name ? documents_->text_or_saved(*name) : nullptr;
  const TextPoint point = read_point(params.at("position"));
  SnapshotPtr snapshot = text ? newest() : nullptr;
  if (!snapshot) return std::nullopt;
  return Asked{*documents_,
               units_,
               std::move(snapshot),
               models_,
               plots_,
               text,
               offset_of(*text, point, units_)};
}

json EditorSession::complete(const json& params) {
  const auto about = asked(params);
  return about ? completion_at(*about) : nullptr;
}

json EditorSession::hover(const json& params) {
  const auto about = asked(params);
  return about ? hover_at(*about) : nullptr;
}

json EditorSession::define(const json& params) {
  const auto about = asked(params);
  return about ? definition_at(*about) : nullptr;
}

json EditorSession::outline(const json& params) {
  const auto name = name_in(params);
  const auto text = name ? documents_->text_or_saved(*name) : nullptr;
  return text ? outline_of(*text, units_) : json(nullptr);
}

json EditorSession::accept(const json& params) {
  const auto name = name_in(params);
  const TextRange range = read_range(params.at("range"));
  const SnapshotPtr snapshot = name && wants_quick_fixes(params) ? newest() : nullptr;
  if (!snapshot) return nullptr;
  return accept_actions(*snapshot, *documents_, *name, range, units_);
}

}  // namespace mjcourse
