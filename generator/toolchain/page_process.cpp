#include "toolchain/page_process.h"

#include <utility>

#include "base/stopwatch.h"
#include "base/temporary_folder.h"
#include "process/process_supervisor.h"

namespace mjcourse {
namespace {

// As long as the longest check, for a limit of the kernel's when nobody is left to look.
constexpr double kLifetime = 24 * 3600;
// Of one answer: what a program prints, and 16 MiB of records as JSON has them.
constexpr std::size_t kMostAnswer = 64 << 20;

Command command_of(const PageToolchain& toolchain, const std::filesystem::path& folder) {
  Command command = toolchain.command(folder);
  command.seconds = kLifetime;
  command.output_bytes = kMostAnswer;
  command.answers = true;
  return command;
}

}  // namespace

class PageProcess::Running {
 public:
  explicit Running(const PageToolchain& toolchain)
      : command_(command_of(toolchain, folder_.path())), supervisor_(command_) {}

  tl::expected<std::string, Outcome> ask(std::string_view question, double seconds) {
    return supervisor_.ask(question, seconds);
  }

 private:
  TemporaryFolder folder_;
  Command command_;
  ProcessSupervisor supervisor_;
};

PageProcess::PageProcess(const PageToolchain& toolchain) : toolchain_(toolchain) {}

PageProcess::~PageProcess() = default;

tl::expected<std::string, Outcome> PageProcess::ask(std::string_view question, double seconds) {
  const Stopwatch stopwatch;
  auto running = std::move(running_);
  if (!running) running = std::make_unique<Running>(toolchain_);
  auto answer = running->ask(question, seconds);
  asked_ += stopwatch.seconds();
  if (answer) running_ = std::move(running);
  return answer;
}

}  // namespace mjcourse
