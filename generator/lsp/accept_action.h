// "Accept": what `mjcourse accept` would write, as an edit that the editor makes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lsp/open_documents.h"
#include "session/snapshot.h"

namespace mjcourse {

// One for each mistake in `range` of the file that an edit mends. Left out are those of files that
// are no longer what they were made from, open or saved, and those that no editor can make:
// pictures.
nlohmann::json accept_actions(const Snapshot& snapshot, const OpenDocuments& documents,
                              const std::string& file, const TextRange& range, Units units);

}  // namespace mjcourse
