#include "lsp/accept_action.h"

#include "base/utf8.h"
#include "lsp/editor_diagnostics.h"
#include "report/file_edits.h"

namespace mjcourse {
namespace {

using nlohmann::json;

bool is_text(const std::string& bytes) {
  return !find_invalid_utf8(bytes) && !find_control_character(bytes);
}

bool meets(const TextRange& one, const TextRange& other) {
  return one.begin.line <= other.end.line && other.begin.line <= one.end.line;
}

// Of a file that is there, the lines that differ; else the whole of a new one.
json workspace_edit(const FileEdit& edit, const Edit& wanted, const OpenDocuments& documents,
                    Units units) {
  const std::string uri = documents.uri_of(edit.file);
  if (edit.before) {
    const SourceText before(edit.file, *edit.before);
    const Span span = wanted.span.value_or(Span{0, edit.before->size()});
    const json change{{"range", json_of(range_of(before, span, units))}, {"newText", wanted.text}};
    return {{"changes", {{uri, json::array({change})}}}};
  }
  const json all{{"range", json_of(TextRange{})}, {"newText", wanted.text}};
  return {{"documentChanges", json::array({{{"kind", "create"}, {"uri", uri}},
                                           {{"textDocument", {{"uri", uri}, {"version", nullptr}}},
                                            {"edits", json::array({all})}}})}};
}

}  // namespace

json accept_actions(const Snapshot& snapshot, const OpenDocuments& documents,
                    const std::string& file, const TextRange& range, Units units) {
  json actions = json::array();
  for (const Diagnostic& diagnostic : snapshot.diagnostics) {
    if (!diagnostic.edit || file_of(diagnostic) != file || !is_text(diagnostic.edit->text) ||
        !meets(range_of(diagnostic.place, units), range)) {
      continue;
    }
    const FileEdits edits = gather_edits({&diagnostic}, documents);
    if (edits.files.empty()) continue;
    actions.push_back(
        {{"title", "Accept " + diagnostic.edit->what},
         {"kind", "quickfix"},
         {"isPreferred", true},
         {"diagnostics", json::array({json_of(diagnostic, documents, units)})},
         {"edit", workspace_edit(edits.files.front(), *diagnostic.edit, documents, units)}});
  }
  return actions;
}

}  // namespace mjcourse
