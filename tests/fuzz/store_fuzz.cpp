// What a store gives, of any bytes, under whatever name: a finding, the lists by which it is found,
// or nothing.
//
// The input: a name that an entry holds, a line `%%%`, the list of what was looked at, a line
// `%%%`, a finding in CBOR.
#include <filesystem>

#include "base/disk_store.h"
#include "base/files.h"
#include "base/temporary_folder.h"
#include "cache/result_store.h"
#include "evaluate/codec/result_codec.h"
#include "evaluate/result_fits.h"
#include "fuzz.h"
#include "lesson/read_lesson.h"
#include "memory_store.h"
#include "require.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Whatever is asked for, one of these is the answer.
class AnyStore : public Store {
 public:
  AnyStore(std::string list, std::string entry)
      : list_(std::move(list)), entry_(std::move(entry)) {}

  std::optional<Stored> find(const std::string& name) override {
    if (name.starts_with("cas/")) return Stored{list_};
    asked_ = !asked_;
    return Stored{asked_ ? list_ : entry_};
  }
  bool keep(const std::string&, std::string_view, const Origin&) override { return true; }

 private:
  std::string list_, entry_;
  bool asked_ = false;
};

struct Input {
  std::string name, list, entry;
};

Input input_of(const std::string& bytes) {
  const std::string between = "\n%%%\n";
  const std::size_t first = std::min(bytes.find(between), bytes.size());
  const std::size_t second = std::min(first + between.size(), bytes.size());
  const std::size_t third = std::min(bytes.find(between, second), bytes.size());
  return {bytes.substr(0, first), bytes.substr(second, third - second),
          bytes.substr(std::min(third + between.size(), bytes.size()))};
}

// A store on the disk, and beside it what is not its own.
class Disk {
 public:
  Disk() : store_(folder_.path() / "store") {
    fs::create_directories(kept());
    write_file(kept() / "file", "mine");
  }

  void check(const std::string& name) {
    for (const std::string& asked : {name, "cas/" + name, "ac/" + name}) store_.get(asked);
    require(fs::exists(kept() / "file"), "what is no entry stays: " + name);
    require(store_.notes().empty(), "nothing of it was damaged: " + name);
  }

  fs::path root() const { return folder_.path(); }

 private:
  fs::path kept() const { return folder_.path() / "kept"; }

  TemporaryFolder folder_;
  DiskStore store_;
};

void check_found(const Input& input, const fs::path& root) {
  AnyStore any(input.list, input.entry);
  Fingerprints fingerprints(root);
  ResultStore results(any, fingerprints);
  results.find({{"kind", "fuzz"}});
  results.one_by_one(results.dependencies_of(input.name));
}

// A lesson with a block of each kind that has parts.
const Lesson& lesson() {
  static const Lesson read = [] {
    Diagnostics none;
    return *read_lesson(
        "content/1-a/1.1-x.md",
        "---\ntitle: T\n---\n"
        "```lab simlab\n{\"title\": \"T\", \"model\": \"m\", \"alt\": \"A.\", \"controls\": "
        "[{\"type\": \"button\", \"label\": \"B\", \"run\": \"1\"}], \"readouts\": "
        "[{\"label\": \"r\", \"expr\": \"1\"}]}\n```\n\n"
        "```cpp file=examples/x.cpp\nint main() {}\n```\n",
        none);
  }();
  return read;
}

void check_fitting(const Result& result) {
  for (const Block& block : lesson().blocks) {
    if (!fits(block, result)) continue;
    const auto* lab = std::get_if<Lab>(&block);
    const auto* known = std::get_if<LabResult>(&result);
    require((lab != nullptr) == (known != nullptr), "a lab's result is a lab's");
    if (lab == nullptr) continue;
    for (const LabRunResult& run : known->runs) {
      require(!run.control || *run.control < lab->controls.size(), "a control is there");
      for (const LabReading& reading : run.readings) {
        require(reading.values.size() == lab->readouts.size(), "each readout was read");
      }
    }
  }
}

void check_finding(const std::string& bytes) {
  MemoryStore store;
  const ResultCodec codec(store, "/course");
  std::optional<Finding> finding = codec.decode(bytes, 0);
  if (!finding) return;
  for (const auto& [block, result] : finding->results) check_fitting(result);
  const auto again = codec.encode(*finding, 0);
  require(again.has_value(), "what was decoded can be encoded");
  std::optional<Finding> same = codec.decode(*again, 0);
  require(same && codec.encode(*same, 0) == again, "and is the same");
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static mjcourse::Disk disk;
  const mjcourse::Input input = mjcourse::input_of(mjcourse::text_of_input(data, size));
  disk.check(input.name);
  mjcourse::check_found(input, disk.root());
  mjcourse::check_finding(input.entry);
  return 0;
}
