#include "base/lock_wait.h"

#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <thread>

#include "base/descriptor.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause(20);

// As /proc/locks names the file.
std::string number_of(const struct stat& file) {
  char text[64];
  std::snprintf(text, sizeof text, "%02x:%02x:%llu", major(file.st_dev), minor(file.st_dev),
                static_cast<unsigned long long>(file.st_ino));
  return text;
}

std::string name_of_process(const std::string& process) {
  std::ifstream file("/proc/" + process + "/comm");
  std::string name;
  std::getline(file, name);
  return readable(name);
}

// A holder that the kernel does not name.
constexpr const char* kSomebody = "another process";

}  // namespace

std::string lock_holder(int file) {
  struct stat status {};
  if (fstat(file, &status) != 0) return kSomebody;
  const std::string wanted = number_of(status);
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {
    // "1: FLOCK  ADVISORY  WRITE 4711 08:01:1234 0 EOF"; who waits has an arrow for the first word.
    std::istringstream words(line);
    std::string number, kind, mode, access, process, name;
    words >> number >> kind >> mode >> access >> process >> name;
    if (kind != "FLOCK" || name != wanted || process.starts_with('-') || process == "0") continue;
    const std::string called = name_of_process(process);
    return "process " + process + (called.empty() ? "" : " (" + called + ")");
  }
  return kSomebody;
}

bool take_lock(int file, int operation, const std::filesystem::path& path, const LockWait& wait) {
  const Clock::time_point begin = Clock::now();
  bool told = false;
  while (flock(file, operation | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) throw_errno(path);
    const Clock::duration waited = Clock::now() - begin;
    if (wait.most && waited >= *wait.most) return false;
    if (!told && wait.tell && waited >= wait.quiet) {
      told = true;
      wait.tell("waiting for " + readable(path.string()) + ", which " + lock_holder(file) +
                " holds");
      continue;
    }
    std::this_thread::sleep_for(kPause);
  }
  return true;
}

}  // namespace mjcourse
