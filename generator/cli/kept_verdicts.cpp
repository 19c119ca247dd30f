#include "cli/kept_verdicts.h"

#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "base/beneath.h"
#include "evaluate/hand_in.h"

namespace mjcourse {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

// The most that a file may have which we wrote.
constexpr std::uintmax_t kMostKeptBytes = 4 << 20;
constexpr int kMostDepth = 16;

std::string name_of(const std::string& key) {
  return "verdicts/" + key + ".json";
}

}  // namespace

KeptVerdicts::KeptVerdicts(const fs::path& out, const fs::path& course) {
  if (!out.empty()) place_.emplace(open_out_place(out, course));
  if (place_) folder_.emplace(place_->folder.inner(place_->name));
}

std::string KeptVerdicts::seed(const std::string& seed, bool is_wanted) const {
  if (!folder_) return seed;
  const auto kept = read("seed");
  std::string known = kept ? kept->substr(0, kept->find('\n')) : "";
  if (is_seed(known) && !is_wanted) return known;
  folder_->write("seed", seed + "\n");
  return seed;
}

std::optional<Grade> KeptVerdicts::find(const std::string& key, const Grade& like) const {
  if (!folder_) return std::nullopt;
  const auto bytes = read(name_of(key));
  if (!bytes) return std::nullopt;
  const auto is_flat = [](int depth, json::parse_event_t, json&) { return depth < kMostDepth; };
  auto kept = grade_of_json(json::parse(*bytes, is_flat, false), like);
  return kept && !kept->may_be_of_others() ? std::move(kept) : std::nullopt;
}

void KeptVerdicts::keep(const std::string& key, const Grade& grade) const {
  if (!folder_ || grade.may_be_of_others()) return;
  folder_->write(name_of(key),
                 judgement_json(grade).dump(1, ' ', false, json::error_handler_t::replace) + "\n");
}

std::optional<std::string> KeptVerdicts::read(const std::string& name) const {
  std::error_code none;
  if (fs::file_size(folder_->path() / name, none) > kMostKeptBytes || none) return std::nullopt;
  const auto bytes = DiskFiles(folder_->path()).read(name);
  return bytes ? std::optional(*bytes) : std::nullopt;
}

}  // namespace mjcourse
