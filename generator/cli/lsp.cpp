// `mjcourse lsp`: the course in an editor, by the Language Server Protocol on stdin and stdout.
#include <chrono>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/kept_results.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "lsp/language_server.h"
#include "session/quick_store.h"

namespace mjcourse {
namespace {

// The protocol's exit code of a server whose editor went away without a word.
constexpr int kLeftAlone = 1;

}  // namespace

int lsp(const LspOptions& options) {
  KeptResults kept(options.store);
  QuickStore store(kept.store());
  const DiskFiles assets(assets_folder());
  Workplace workplace = workplace_of(options, assets, &store);
  workplace.known_files = std::make_shared<KnownFiles>(kPatienceWhileEditing);
  LanguageServer server({workplace, options.course_named, MJCOURSE_VERSION}, std::cout);
  return server.run(std::cin) ? kClean : kLeftAlone;
}

}  // namespace mjcourse
