// PreparedFiles: what the compiler made of headers alone, kept for every later program and run.
//
// Enter with get(). An entry is a folder of files, made once for a request (a text that says all
// that went in but the contents of files) and made again when one of the files that were read for
// it has another content. It is written aside, brought to the disk and renamed, so who reads sees
// all of it or nothing; of several processes that want it, one makes it and the others wait. What
// was not used for longest goes when all together is too large.
//
//   FOLDER/REQUEST/current   which entry is the current one, and the hash and path of its inputs
//   FOLDER/REQUEST/ENTRY/    its files; no such folder where there was something to refuse
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

class PreparedFiles {
 public:
  struct Entry {
    std::filesystem::path folder;
    std::vector<std::string> inputs;  // absolute paths, sorted: the files that were read for it
  };

  struct Made {
    bool worked = false;              // false: these inputs do not give it, and need no new trial
    std::vector<std::string> inputs;  // as in Entry
  };
  // Writes the files into `staging`. `request` is where files may be put that have to stay where
  // they are from then on. Nothing where it could not be tried: the disk is full, say.
  using Make = std::function<std::optional<Made>(const std::filesystem::path& request,
                                                 const std::filesystem::path& staging)>;

  // Without a folder nothing is kept, and nothing made.
  explicit PreparedFiles(std::optional<std::filesystem::path> folder,
                         std::uintmax_t most_bytes = std::uintmax_t{1} << 30)
      : folder_(std::move(folder)), most_bytes_(most_bytes) {}

  // The entry; null where it cannot be had. Looked for once: who asks again has the same answer.
  // Safe to call from several threads, which wait for the first of them.
  std::shared_ptr<const Entry> get(const std::string& request, const Make& make);

  // The entry is of no use: the next process makes it anew.
  static void drop(const Entry& entry);

 private:
  std::shared_ptr<const Entry> find_or_make(const std::filesystem::path& folder, const Make& make);

  std::optional<std::filesystem::path> folder_;
  std::uintmax_t most_bytes_;
  std::mutex mutex_;
  std::map<std::string, std::shared_future<std::shared_ptr<const Entry>>> asked_;  // by request
};

}  // namespace mjcourse
