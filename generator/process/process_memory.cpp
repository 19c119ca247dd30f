#include "process/process_memory.h"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

ssize_t read_bytes(pid_t process, std::uint64_t address, char* into, std::size_t size) {
  const iovec local{into, size};
  const iovec remote{std::bit_cast<void*>(address), size};
  return process_vm_readv(process, &local, 1, &remote, 1, 0);
}

std::optional<std::string> link_at(const std::string& link) {
  std::error_code error;
  const fs::path target = fs::read_symlink(link, error);
  return error ? std::nullopt : std::optional(target.string());
}

}  // namespace

tl::expected<std::string, int> read_text(pid_t process, std::uint64_t address) {
  constexpr std::uint64_t page = 4096;
  std::string text;
  // Page by page: behind the end of a text there need not be any memory.
  while (text.size() <= PATH_MAX) {
    std::array<char, page> part;
    const std::uint64_t at = address + text.size();
    const ssize_t count = read_bytes(process, at, part.data(), page - at % page);
    if (count <= 0) return tl::unexpected(count < 0 ? errno : EFAULT);
    const std::size_t length = strnlen(part.data(), static_cast<std::size_t>(count));
    text.append(part.data(), length);
    if (length < static_cast<std::size_t>(count)) return text;
  }
  return tl::unexpected(EFAULT);  // longer than any path
}

bool read_memory(pid_t process, std::uint64_t address, std::span<char> into) {
  return read_bytes(process, address, into.data(), into.size()) == std::ssize(into);
}

std::optional<std::uint64_t> read_number(pid_t process, std::uint64_t address) {
  std::array<char, sizeof(std::uint64_t)> bytes{};
  if (!read_memory(process, address, bytes)) return std::nullopt;
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data(), sizeof number);
  return number;
}

std::optional<std::string> absolute_path(pid_t process, int folder, const std::string& path) {
  if (path.starts_with('/')) return path;
  const std::string links = "/proc/" + std::to_string(process);
  auto base = link_at(links + (folder == AT_FDCWD ? "/cwd" : "/fd/" + std::to_string(folder)));
  if (!base || path.empty()) return base;
  return *base + "/" + path;
}

bool shares_process(pid_t thread, pid_t other) {
  std::error_code none;
  return fs::exists("/proc/" + std::to_string(other) + "/task/" + std::to_string(thread), none);
}

int count_threads(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("Threads:")) return std::stoi(line.substr(8));
  }
  return 0;
}

}  // namespace mjcourse
