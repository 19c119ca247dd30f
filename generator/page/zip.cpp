#include "page/zip.h"

#include <zip.h>

#include <memory>
#include <stdexcept>

namespace mjcourse {
namespace {

constexpr zip_uint16_t kFirstDay = 1 << 5 | 1;                    // January 1, 1980
constexpr zip_uint32_t kPlainFile = zip_uint32_t{0100644} << 16;  // as Unix has it
constexpr zip_uint32_t kSmallest = 9;                             // of zlib's levels

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using Source = std::unique_ptr<zip_source_t, decltype(&zip_source_free)>;

[[noreturn]] void give_up(const std::string& what) {
  throw std::runtime_error("libzip: " + what);
}

void add(zip_t* archive, const std::string& path, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  const zip_int64_t added =
      source == nullptr ? -1 : zip_file_add(archive, path.c_str(), source, ZIP_FL_ENC_UTF_8);
  const auto index = static_cast<zip_uint64_t>(added);
  if (added < 0 || zip_file_set_dostime(archive, index, 0, kFirstDay, 0) != 0 ||
      zip_set_file_compression(archive, index, ZIP_CM_DEFLATE, kSmallest) != 0 ||
      zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, kPlainFile) != 0) {
    give_up(path + ": " + zip_strerror(archive));
  }
}

std::string bytes_of(zip_source_t* source) {
  zip_stat_t stat;
  if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0) give_up("no archive");
  std::string bytes(stat.size, '\0');
  const zip_int64_t read = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (read != static_cast<zip_int64_t>(bytes.size())) give_up("half an archive");
  return bytes;
}

}  // namespace

std::string zip_of(const std::map<std::string, std::string>& files) {
  const Source target(zip_source_buffer_create(nullptr, 0, 0, nullptr), zip_source_free);
  if (!target) give_up("no memory");
  zip_source_keep(target.get());  // the archive gives one hold of it up
  Archive archive(zip_open_from_source(target.get(), ZIP_TRUNCATE, nullptr), zip_discard);
  if (!archive) give_up("no archive");
  for (const auto& [path, bytes] : files) add(archive.get(), path, bytes);
  if (zip_close(archive.get()) != 0) give_up(zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // closed
  return bytes_of(target.get());
}

}  // namespace mjcourse
