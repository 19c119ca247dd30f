// `mjcourse lsp`: the course in an editor, by the Language Server Protocol on stdin and stdout.
// Tested by tests/lsp/sessions.mjs.
#include <chrono>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/open_store.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "lsp/language_server.h"
#include "session/write_behind_store.h"

namespace mjcourse {
namespace {

// The protocol's exit code of a server whose editor went away without a word.
constexpr int kLeftAlone = 1;

}  // namespace

int lsp(const LspOptions& options) {
  const OpenedStore opened = open_store(options.store, options.shared);
  WriteBehindStore store(opened.get());
  const DiskFiles assets(assets_folder());
  EvaluationSettings settings = evaluation_settings(options, assets, &store);
  settings.fingerprint_cache = std::make_shared<FingerprintCache>(kPatienceWhileEditing);
  LanguageServer server({settings, options.course_named, MJCOURSE_VERSION}, std::cout);
  return server.run(std::cin) ? kClean : kLeftAlone;
}

}  // namespace mjcourse
