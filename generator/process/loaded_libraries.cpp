#include "process/loaded_libraries.h"

#include <elf.h>
#include <fcntl.h>
#include <link.h>
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "base/late_library.h"
#include "base/sha256.h"
#include "base/text_lines.h"
#include "process/subprocess.h"

namespace mjcourse {
namespace {

// dl_iterate_phdr's way to say where the linker is that the program, its first, asks for.
int read_linker(dl_phdr_info* info, std::size_t, void* into) {
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = info->dlpi_phdr[i];
    if (header.p_type != PT_INTERP) continue;
    *static_cast<std::string*>(into) = std::bit_cast<const char*>(info->dlpi_addr + header.p_vaddr);
  }
  return 1;
}

// What the linker lists: "	NAME => FILE (ADDRESS)", or "	FILE (ADDRESS)" of one that was
// named so.
std::string what_linker_lists() {
  std::string linker;
  dl_iterate_phdr(read_linker, &linker);
  // It loads them in this order, and then what they need, as it does when they are loaded late.
  std::string first = "LD_PRELOAD=";
  if (const char* const own = std::getenv("LD_PRELOAD")) first += own;
  for (const char* const library : kLateLibraries) first += std::string(" ") + library;
  Command command;
  command.arguments = {linker, "--list", std::filesystem::read_symlink("/proc/self/exe").string()};
  command.environment = {std::move(first)};
  command.seconds = 60;  // of a machine that is busy
  const Outcome outcome = run(command);
  if (outcome.end == Outcome::End::exited && outcome.code == 0) return outcome.out;
  throw std::runtime_error(linker + " does not list the libraries of this program: " + outcome.err);
}

std::uint64_t padded(std::uint64_t size) {
  return (size + 3) / 4 * 4;
}

// The note NT_GNU_BUILD_ID among the notes in `segment`; empty where there is none.
std::string build_id(std::string_view segment) {
  ElfW(Nhdr) note;
  while (segment.size() >= sizeof note) {
    std::memcpy(&note, segment.data(), sizeof note);
    const std::uint64_t begin = sizeof note + padded(note.n_namesz);
    const std::uint64_t size = begin + padded(note.n_descsz);
    if (size > segment.size()) break;
    if (note.n_type == NT_GNU_BUILD_ID) return std::string(segment.substr(begin, note.n_descsz));
    segment.remove_prefix(size);
  }
  return "";
}

// Shorter where the file ends.
std::string read_at(const Descriptor& file, std::uint64_t offset, std::uint64_t size) {
  std::string bytes(size, '\0');
  const ssize_t count = pread(file.get(), bytes.data(), size, static_cast<off_t>(offset));
  bytes.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  return bytes;
}

// In hexadecimal digits; empty where the file, or the id in it, is missing.
std::string build_id_of(const std::string& path) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  ElfW(Ehdr) library{};
  const std::string begin = read_at(file, 0, sizeof library);
  std::memcpy(&library, begin.data(), begin.size());
  std::string digits;
  for (unsigned i = 0; i < library.e_phnum; ++i) {
    ElfW(Phdr) header{};
    const std::string part = read_at(file, library.e_phoff + i * sizeof header, sizeof header);
    std::memcpy(&header, part.data(), part.size());
    if (header.p_type != PT_NOTE) continue;
    for (const char character : build_id(read_at(file, header.p_offset, header.p_filesz))) {
      const auto byte = static_cast<unsigned char>(character);
      digits += {"0123456789abcdef"[byte >> 4], "0123456789abcdef"[byte & 15]};
    }
  }
  return digits;
}

std::map<std::string, std::string> find_builds() {
  std::map<std::string, std::string> found;
  const std::string listed = what_linker_lists();
  for (const std::string_view line : lines_of(listed)) {
    const std::string_view library = trimmed(line.substr(0, line.rfind(" (0x")));
    const auto arrow = library.find(" => ");
    const bool named = arrow != library.npos;
    const std::string file(named ? library.substr(arrow + 4) : library);
    const std::string name(named ? library.substr(0, arrow) : file.substr(file.rfind('/') + 1));
    // The program itself, whose sources have a hash of their own, and what is the kernel's.
    if (!name.empty() && !name.starts_with("linux-vdso"))
      found.insert_or_assign(name, build_id_of(file));
  }
  return found;
}

std::string hash_loaded() {
  Sha256 hash;
  for (const auto& [library, id] : library_builds()) hash.add(library).add(id);
  return hash.hex();
}

}  // namespace

const std::map<std::string, std::string>& library_builds() {
  static const std::map<std::string, std::string> builds = find_builds();
  return builds;
}

const std::string& loaded_libraries() {
  static const std::string hash = hash_loaded();
  return hash;
}

}  // namespace mjcourse
