// `mjcourse store prune --keep SIZE`.
#include <iostream>

#include "base/counted.h"
#include "cli/commands.h"
#include "cli/run.h"
#include "cli/size.h"

namespace mjcourse {

int store(const Options& options) {
  if (options.where != std::vector<std::string>{"prune"}) {
    std::cerr << "mjcourse: store what? `mjcourse store prune` forgets old results\n"
                 "`mjcourse --help` shows the commands\n";
    return kWrongUsage;
  }
  const std::filesystem::path folder = store_folder(options.store);
  const Pruned pruned = prune_store(folder, options.keep, true).value();
  std::cout << "forgot " << counted(pruned.entries, "result", "results") << " ("
            << size_text(pruned.bytes) << "); " << pruned.entries_left << " are kept ("
            << size_text(pruned.bytes_left) << ")\n";
  return kClean;
}

}  // namespace mjcourse
