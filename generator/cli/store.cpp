// `mjcourse store prune --keep SIZE`, `store push` and `store pull`.
// Tested by tests/generator/cli/run_test.cpp.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iostream>
#include <system_error>

#include "base/counted.h"
#include "base/descriptor.h"
#include "base/nearest.h"
#include "base/out_folder.h"
#include "base/prune_store.h"
#include "cli/commands.h"
#include "cli/new_files.h"
#include "cli/open_store.h"
#include "cli/run.h"
#include "cli/size.h"
#include "cli/verify.h"
#include "evaluate/explain.h"
#include "process/our_command.h"
#include "remote/signature.h"

namespace mjcourse {
namespace {

// "3 results and 1 prepared header (12 MB)"
std::string in_words(const Pruned::Count& count) {
  return counted(count.results, "result", "results") + " and " +
         counted(count.prepared, "prepared header", "prepared headers") + " (" +
         size_text(count.bytes) + ")";
}

int prune(const StoreOptions& options) {
  try {
    const LockWait wait{.tell = [](const std::string& text) {
      std::cerr << "note: " << text << "; end it, or interrupt this\n";
    }};
    const Pruned pruned = prune_store(store_folder(options.store), options.keep, wait).value();
    for (const std::string& note : pruned.notes) std::cerr << "note: " << note << '\n';
    std::cout << "forgot " << in_words(pruned.removed) << "; kept " << in_words(pruned.left)
              << '\n';
    return kClean;
  } catch (const std::system_error& error) {
    return tell(Refusal{kWrongUsage, "the store cannot be pruned: " + std::string(error.what()),
                        "name a store that you can write to: `--store DIR`"});
  }
}

// Between the disk and the shared store, all that is kept of the course as it is now.
int transfer(StoreOptions options, bool pushes) {
  const auto server = named_server(options.shared);
  if (!server) return tell(Refusal{kWrongUsage, server.error(), "set it right, or unset it"});
  if (!*server) {
    return tell(Refusal{
        kWrongUsage, std::string("store ") + (pushes ? "push" : "pull") + " needs a shared store",
        "name it: `--store-url URL`, MJCOURSE_STORE_URL in the environment, or `store: URL` in "
        "~/.config/mjcourse/config.yaml"});
  }
  if (pushes && options.shared.read_only) {
    return tell(Refusal{kWrongUsage, "store push would put something, and the store is read only",
                        "leave out `--store-read-only`, here and in your settings"});
  }
  options.shared.gets_all = pushes;
  const Verified verified = read_course_of(options);
  if (!verified.course) {
    print_diagnostics(verified.evaluation.diagnostics);
    return kCourseErrors;
  }
  const RemoteStore* const remote = verified.store.remote();
  if (remote == nullptr) return kCourseErrors;  // a note has said why
  const DiskFiles assets(assets_folder());
  const auto tasks = explain_course(
      *verified.course, evaluation_settings(options, assets, verified.store.get()), pushes);
  verified.store.wait();
  const auto kept = std::ranges::count_if(tasks, &Explanation::kept);
  const auto foreign = kept - std::ranges::count_if(tasks, &Explanation::made_here);
  if (pushes && kept == 0) {
    return tell(Refusal{kCourseErrors, "the disk has no result of this course",
                        our_command("check") + " works them out"});
  }
  const RemoteStore::Traffic traffic = remote->traffic();
  std::cout << (pushes ? "put " + counted(traffic.put, "entry", "entries") + " (" +
                             size_text(traffic.sent) + ") into "
                       : "got " + counted(traffic.found, "entry", "entries") + " (" +
                             size_text(traffic.received) + ") from ")
            << (*server)->address.shown() << "; the disk has " << kept << " of "
            << counted(tasks.size(), "result") << " of this course";
  if (pushes && foreign > 0) {
    std::cout << "; " << foreign
              << " came from elsewhere, or an earlier version does not say whence, and are not put";
  }
  std::cout << '\n';
  return remote->notes().empty() ? kClean : kCourseErrors;
}

// The public key is for others.
int make_key(const std::filesystem::path& path, const std::filesystem::path& course) {
  const OutPath found = find_out_path(path, course);
  if (found.is_link) {
    return tell(Refusal{kCourseErrors, found.shown + " is a link, so nothing is written there",
                        "name a new file elsewhere"});
  }
  const SigningKey key = SigningKey::random();
  const std::string file = key.file();
  const Descriptor to(
      open(found.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR));
  if (!to.is_open() ||
      write(to.get(), file.data(), file.size()) != static_cast<ssize_t>(file.size())) {
    return tell(Refusal{kWrongUsage, path.string() + ": " + std::strerror(errno),
                        "name a new file; a key is never replaced"});
  }
  std::cout
      << "wrote " << path.string()
      << ": MJCOURSE_STORE_SIGNING_KEY names this file where results are signed; keep it secret\n"
      << "its public key, for MJCOURSE_STORE_TRUSTED_KEYS elsewhere:\n"
      << key.public_key() << '\n';
  return kClean;
}

}  // namespace

int store(const StoreOptions& options) {
  const std::vector<std::string> known{"prune", "push", "pull", "key"};
  const bool is_key = !options.words.empty() && options.words[0] == "key";
  if (options.words.size() != (is_key ? 2 : 1)) {
    std::cerr << (is_key ? "mjcourse: store key takes one new file\n"
                         : "mjcourse: store what? prune, push, pull or key\n")
              << our_command("store --help") << " shows what it takes\n";
    return kWrongUsage;
  }
  const std::string& what = options.words[0];
  if (is_key) return make_key(options.words[1], options.course);
  if (what == "prune") return prune(options);
  if (what == "push" || what == "pull") return transfer(options, what == "push");
  return tell(Refusal{kWrongUsage, "store cannot " + what, suggest(what, known)});
}

}  // namespace mjcourse
