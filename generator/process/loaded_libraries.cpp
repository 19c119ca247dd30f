#include "process/loaded_libraries.h"

#include <elf.h>
#include <link.h>

#include <bit>
#include <cstdint>
#include <string_view>

#include "base/sha256.h"

namespace mjcourse {
namespace {

std::uint64_t padded(std::uint64_t size) {
  return (size + 3) / 4 * 4;
}

// The note NT_GNU_BUILD_ID among the notes in `segment`; empty where there is none.
std::string_view build_id(std::string_view segment) {
  while (segment.size() >= sizeof(ElfW(Nhdr))) {
    const auto* note = reinterpret_cast<const ElfW(Nhdr)*>(segment.data());
    const std::uint64_t begin = sizeof(*note) + padded(note->n_namesz);
    const std::uint64_t size = begin + padded(note->n_descsz);
    if (size > segment.size()) break;
    if (note->n_type == NT_GNU_BUILD_ID) return segment.substr(begin, note->n_descsz);
    segment.remove_prefix(size);
  }
  return "";
}

// dl_iterate_phdr's way to say a library: its name without the folder, and its id.
int add_library(dl_phdr_info* info, std::size_t, void* into) {
  const std::string_view path = info->dlpi_name;
  const std::string library(path.substr(path.rfind('/') + 1));
  // The program itself, whose sources have a hash of their own, and what is the kernel's.
  if (library.empty() || library.starts_with("linux-vdso")) return 0;
  std::string id;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = info->dlpi_phdr[i];
    if (header.p_type != PT_NOTE) continue;
    const auto* notes = std::bit_cast<const char*>(info->dlpi_addr + header.p_vaddr);
    for (const char character : build_id({notes, static_cast<std::size_t>(header.p_memsz)})) {
      const auto byte = static_cast<unsigned char>(character);
      id += {"0123456789abcdef"[byte >> 4], "0123456789abcdef"[byte & 15]};
    }
  }
  static_cast<std::map<std::string, std::string>*>(into)->insert_or_assign(library, id);
  return 0;
}

std::string hash_loaded() {
  Sha256 hash;
  for (const auto& [library, id] : library_builds()) hash.add(library).add(id);
  return hash.hex();
}

}  // namespace

const std::map<std::string, std::string>& library_builds() {
  static const std::map<std::string, std::string> builds = [] {
    std::map<std::string, std::string> found;
    dl_iterate_phdr(add_library, &found);
    return found;
  }();
  return builds;
}

const std::string& loaded_libraries() {
  static const std::string hash = hash_loaded();
  return hash;
}

}  // namespace mjcourse
