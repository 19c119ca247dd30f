// `mjcourse store prune --keep SIZE`.
// Tested by tests/generator/cli/run_test.cpp.
#include <iostream>
#include <system_error>

#include "base/counted.h"
#include "base/disk_store.h"
#include "cli/commands.h"
#include "cli/new_files.h"
#include "cli/open_store.h"
#include "cli/run.h"
#include "cli/size.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

// "3 results and 1 prepared header (12 MB)"
std::string in_words(const Pruned::Count& count) {
  return counted(count.results, "result", "results") + " and " +
         counted(count.prepared, "prepared header", "prepared headers") + " (" +
         size_text(count.bytes) + ")";
}

}  // namespace

int store(const StoreOptions& options) {
  if (options.words != std::vector<std::string>{"prune"}) {
    std::cerr << "mjcourse: store what? " << our_command("store prune") << " forgets old results\n"
              << our_command("store --help") << " shows what it takes\n";
    return kWrongUsage;
  }
  const std::filesystem::path folder = store_folder(options.store);
  try {
    const Pruned pruned = prune_store(folder, options.keep, true).value();
    std::cout << "forgot " << in_words(pruned.removed) << "; kept " << in_words(pruned.left)
              << '\n';
    return kClean;
  } catch (const std::system_error& error) {
    return tell(Refusal{kWrongUsage, "the store cannot be pruned: " + std::string(error.what()),
                        "name a store that you can write to: `--store DIR`"});
  }
}

}  // namespace mjcourse
