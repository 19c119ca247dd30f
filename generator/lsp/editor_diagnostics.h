// Diagnostics as an editor shows them, and which files have some.
#pragma once

#include <set>
#include <string>

#include "lsp/connection.h"
#include "lsp/open_documents.h"
#include "report/diagnostic.h"

namespace mjcourse {

// As the protocol has them. The range is counted in the line that the diagnostic brings along: the
// file may have changed since.
TextRange range_of(const Place& place, Units units);
nlohmann::json json_of(const Diagnostic& diagnostic, const OpenDocuments& documents, Units units);

// The file that it is shown in: what belongs to none belongs to the course.
std::string file_of(const Diagnostic& diagnostic);

class EditorDiagnostics {
 public:
  // Both must outlive this.
  EditorDiagnostics(const OpenDocuments& documents, Connection& connection)
      : documents_(documents), connection_(connection) {}

  // All that is wrong now. From one thread at a time.
  void publish(const Diagnostics& diagnostics, Units units);

 private:
  const OpenDocuments& documents_;
  Connection& connection_;
  std::set<std::string> marked_;  // files that the editor shows something in
};

}  // namespace mjcourse
