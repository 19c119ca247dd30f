#include "page/precompressed.h"

#include <brotli/encode.h>
#include <zlib.h>

#include <set>
#include <stdexcept>
#include <vector>

#include "base/files.h"
#include "base/parallel.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr int kGzipHead = 16;  // added to zlib's window: a gzip file and no bare stream
constexpr int kMostMemory = 9;

bool is_loose(const fs::path& file) {
  static const std::set<std::string> endings{".cpp",  ".css", ".csv", ".html", ".js",
                                             ".json", ".mjs", ".svg", ".txt",  ".wasm",
                                             ".xml",  ".h",   ".hpp", ".md"};
  return endings.contains(file.extension().string());
}

// Their paths below the site.
std::vector<std::string> loose_files(const fs::path& site) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(site)) {
    if (!entry.is_regular_file() || !is_loose(entry.path())) continue;
    files.push_back(entry.path().lexically_relative(site).string());
  }
  return files;
}

}  // namespace

std::string brotli(std::string_view bytes) {
  std::size_t size = BrotliEncoderMaxCompressedSize(bytes.size());
  std::string packed(size, '\0');
  const auto* in = reinterpret_cast<const std::uint8_t*>(bytes.data());
  auto* out = reinterpret_cast<std::uint8_t*>(packed.data());
  if (BrotliEncoderCompress(BROTLI_MAX_QUALITY, BROTLI_DEFAULT_WINDOW, BROTLI_MODE_GENERIC,
                            bytes.size(), in, &size, out) != BROTLI_TRUE) {
    throw std::runtime_error("brotli: no memory");
  }
  packed.resize(size);
  return packed;
}

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + kGzipHead, kMostMemory,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("zlib: no memory");
  }
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  // zlib reads, and does not say so.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const bool whole = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (!whole) throw std::runtime_error("zlib: half a file");
  return packed;
}

void precompress(const OutFolder& site, std::size_t threads) {
  const std::vector<std::string> files = loose_files(site.path());
  const DiskFiles written(site.path());
  for_each_index(files.size(), threads, [&](std::size_t index, std::size_t) {
    const std::string bytes = written.read(files[index]).value();
    const auto write_smaller = [&](const char* ending, const std::string& packed) {
      if (packed.size() < bytes.size()) site.write(files[index] + ending, packed);
    };
    write_smaller(".br", brotli(bytes));
    write_smaller(".gz", gzip(bytes));
  });
}

}  // namespace mjcourse
