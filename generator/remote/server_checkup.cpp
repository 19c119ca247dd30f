#include "remote/server_checkup.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "base/sha256.h"
#include "base/stopwatch.h"
#include "base/store_entry.h"
#include "remote/action_result.h"
#include "remote/http_client.h"

namespace mjcourse {
namespace {

constexpr std::array<std::size_t, 4> kSizes{1 << 10, 1 << 20, 8 << 20, kLargestTried};
constexpr int kLatencies = 5;

// The same each time, and nothing that a server could make smaller.
std::string bytes_of(std::size_t size) {
  std::mt19937_64 random(size);
  std::string bytes;
  bytes.reserve(size);
  while (bytes.size() < size) {
    for (std::uint64_t word = random(), i = 0; i < sizeof word; ++i, word >>= 8) {
      bytes += static_cast<char>(word & 0xff);
    }
  }
  return bytes;
}

class Examiner {
 public:
  Examiner(const std::filesystem::path& program, const Server& server) : client_(program, server) {}

  ServerCheckup run(bool puts) {
    if (is_there() && puts) try_to_put();
    return std::move(found_);
  }

 private:
  // Asks for entries that do not exist.
  bool is_there() {
    std::vector<double> times;
    std::random_device random;
    for (int i = 0; i < kLatencies; ++i) {
      const std::string name = sha256("nobody has put this here " + std::to_string(random()));
      const Stopwatch stopwatch;
      const HttpAnswer answer = client_.ask("GET", "cas/" + name);
      times.push_back(stopwatch.seconds() * 1000);
      found_.protocol = answer.version;
      if (answer.status == kNotFound) continue;
      found_.trouble = answer.trouble();
      if (answer.status == kOk) found_.trouble += " to what nobody has put there";
      return false;
    }
    std::ranges::sort(times);
    found_.milliseconds = times[times.size() / 2];
    return true;
  }

  void try_to_put() {
    if (!takes_entry()) return;
    for (const std::size_t size : kSizes) {
      const std::string bytes = bytes_of(size);
      if (!takes("cas/" + sha256(bytes), bytes)) break;
      found_.largest = size;
    }
    if (found_.largest == 0) return;
    found_.takes = true;
    const HttpAnswer told = client_.ask("HEAD", "cas/" + sha256(bytes_of(kSizes[0])));
    found_.tells = told.status == kOk;
  }

  bool takes_entry() {
    const std::string name = "ac/" + sha256("mjcourse doctor");
    return takes(name, action_result(sealed(name, "mjcourse doctor")));
  }

  bool takes(const std::string& path, const std::string& bytes) {
    const HttpAnswer put = client_.ask("PUT", path, bytes);
    if (!put.is_good()) {
      found_.refusal = put.trouble();
      found_.forbids = put.status == kUnauthorized || put.status == kForbidden ||
                       put.status == kMethodNotAllowed;
      return false;
    }
    const HttpAnswer got = client_.ask("GET", path);
    if (got.status == kOk && got.content == bytes) return true;
    found_.refusal = "what is put there is not there then";
    return false;
  }

  HttpClient client_;
  ServerCheckup found_;
};

}  // namespace

ServerCheckup examine_server(const std::filesystem::path& program, const Server& server,
                             bool puts) {
  return Examiner(program, server).run(puts);
}

}  // namespace mjcourse
