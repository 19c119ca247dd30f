// `mjcourse preview`: the course in a browser, kept up to date while it is being written.
// Tested by tests/preview/edits.mjs.
#include "preview/preview.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <system_error>
#include <thread>

#include "base/counted.h"
#include "base/descriptor.h"
#include "cli/commands.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "preview/preview_server.h"
#include "process/subprocess.h"
#include "session/write_behind_store.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Ctrl-C and its like, for the thread that waits for them.
class Interrupt {
 public:
  Interrupt() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw_errno("pipe");
    }
    struct sigaction action {};
    action.sa_handler = [](int) {
      const int before = errno;
      [[maybe_unused]] const ssize_t told = write(ends_[1], "", 1);
      errno = before;
    };
    action.sa_flags = static_cast<int>(SA_RESETHAND);  // a second one ends us at once
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  }

  void wait() const {
    pollfd told{ends_[0], POLLIN, 0};
    while (poll(&told, 1, -1) < 0 && errno == EINTR) {
    }
  }

 private:
  static inline std::array<int, 2> ends_{-1, -1};
};

// Says what is wrong when that has changed, and that nothing is any more.
class Teller {
 public:
  void tell(const Snapshot& snapshot) {
    if (snapshot.evaluation->open) return;  // more is known soon
    std::string all;
    for (const Diagnostic& one : snapshot.diagnostics) {
      all += one.place.file + std::to_string(one.place.line) + one.message + one.detail;
    }
    if (std::exchange(said_, all) == all) return;
    print_diagnostics(snapshot.diagnostics);
    std::cerr << counted(count_errors(snapshot.diagnostics), "error") << '\n';
  }

 private:
  std::string said_;
};

// The site's sources, where this program and its assets lie in a build tree of theirs.
fs::path site_sources() {
  const fs::path site = fs::weakly_canonical(assets_folder() / "../../../site");
  const bool edited = fs::exists(site / "bundle/restyle.mjs") && fs::exists(site / "node_modules");
  return edited ? site : fs::path();
}

void open_browser(const std::string& address) {
  Command command;
  command.arguments = {"xdg-open", address};
  command.folder = "/";
  const Outcome outcome = run(command);
  if (outcome.end == Outcome::End::exited && outcome.code == 0) return;
  std::cerr << "no browser could be opened (xdg-open, of the package xdg-utils, does that)\n";
}

}  // namespace

int preview(const PreviewOptions& options) {
  const Interrupt interrupt;
  const OpenedStore opened = open_store(options.store, options.shared);
  WriteBehindStore store(opened.get());
  const DiskFiles assets(assets_folder());
  Teller teller;
  EvaluationSettings settings = evaluation_settings(options, assets, &store);
  settings.fingerprint_cache = std::make_shared<FingerprintCache>(kPatienceWhileEditing);
  Preview preview({settings, assets_folder(), site_sources(), options.link},
                  [&](const Snapshot& snapshot) { teller.tell(snapshot); });
  PreviewServer server(preview, options.port);
  const std::jthread answering([&] { server.run(); });
  std::cout << "preview: " << server.address() << "  (Ctrl-C ends it)\n" << std::flush;
  if (options.open) open_browser(server.address());
  interrupt.wait();
  server.stop();
  return kClean;
}

}  // namespace mjcourse
