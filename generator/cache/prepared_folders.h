// PreparedFolders: folders of files, each made once for a request and kept for later programs and
// runs.
//
// Enter with find() or get(). A request is a text that says all that went in but the contents of
// files. An entry is made again when one of the files that were read for it has another content. It
// is written aside, brought to the disk and renamed, so a reader sees all of it or nothing; of
// several processes that want it, one makes it and the others wait. What was not used for longest
// goes when all together is too large.
//
//   FOLDER/REQUEST/current   which entry is the current one, or that there was something to refuse;
//                            and the hash and name of its inputs
//   FOLDER/REQUEST/ENTRY/    its files
#pragma once

#include <chrono>
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

class PreparedFolders {
 public:
  struct Entry {
    std::filesystem::path folder;
    std::vector<std::string> inputs;  // absolute paths, sorted: the files that were read for it
  };
  // The absolute path of an input by the name that its maker gave it.
  using TruePath = std::function<std::string(const std::string& name)>;

  struct Made {
    bool worked = false;              // false: these inputs do not give it, and need no new trial
    std::vector<std::string> inputs;  // their names, which are what is kept
  };
  // Writes the files into `staging`. `request` is where files may be put that have to stay where
  // they are from then on. Nothing where it could not be tried: the disk is full, say.
  using Make = std::function<std::optional<Made>(const std::filesystem::path& request,
                                                 const std::filesystem::path& staging)>;

  // Without a folder nothing is kept, and nothing made.
  explicit PreparedFolders(
      std::optional<std::filesystem::path> folder,
      TruePath true_path = [](const std::string& name) { return name; },
      std::uintmax_t most_bytes = std::uintmax_t{1} << 30,
      std::chrono::milliseconds patience = std::chrono::minutes(2))
      : folder_(std::move(folder)),
        true_path_(std::move(true_path)),
        most_bytes_(most_bytes),
        patience_(patience) {}

  bool keeps() const { return folder_.has_value(); }

  // The entry, where it was made before, by whomever; null where it was not, or cannot be had. From
  // any thread; waits for no thread that makes it.
  std::shared_ptr<const Entry> find(const std::string& request);
  // The entry, made where it is not there; null where it cannot be had. A caller that asks again
  // has the same answer. From any thread; those that ask for the same wait for the first of them.
  std::shared_ptr<const Entry> get(const std::string& request, const Make& make);

  // The entry is of no use: the next process makes it anew.
  static void drop(const Entry& entry);

 private:
  struct Found {
    bool current = false;                // what is there was made of the inputs as they are now
    std::shared_ptr<const Entry> entry;  // null where these inputs do not give one
  };
  Found look(const std::filesystem::path& folder) const;
  std::shared_ptr<const Entry> find_or_make(const std::filesystem::path& folder, const Make& make);
  std::shared_ptr<const Entry> make_anew(const std::filesystem::path& folder, const Make& make);

  std::optional<std::filesystem::path> folder_;
  TruePath true_path_;
  std::uintmax_t most_bytes_;
  std::chrono::milliseconds patience_;  // with one who makes the same
  std::mutex mutex_;
  std::map<std::string, std::shared_future<std::shared_ptr<const Entry>>> asked_;  // by request
  std::map<std::string, std::shared_ptr<const Entry>> found_;                      // by request
};

}  // namespace mjcourse
