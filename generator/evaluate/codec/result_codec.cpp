#include "evaluate/codec/result_codec.h"

#include <algorithm>
#include <utility>

#include "base/sha256.h"
#include "cache/cbor.h"
#include "evaluate/codec/blobs_of.h"
#include "evaluate/codec/result_json.h"

namespace mjcourse {

using nlohmann::json;

namespace {

namespace fs = std::filesystem;

// Paths below the course's folder, and back; others are the system's, and the same everywhere.
template <typename Change>
void change_paths(Finding& finding, const Change& change) {
  const auto change_lab = [&](LabResult& lab) {
    for (auto& [name, path] : lab.model.assets) path = change(path);
  };
  for (auto& [block, result] : finding.results) {
    if (auto* lab = std::get_if<LabResult>(&result)) change_lab(*lab);
  }
  if (finding.model_page && finding.model_page->lab) change_lab(finding.model_page->lab->result);
}

}  // namespace

bool ResultCodec::keep_blobs(Finding& finding) const {
  return std::ranges::all_of(blobs_of(finding), [&](Blob* blob) { return blob->keep_in(store_); });
}

std::optional<std::string> ResultCodec::encode(Finding& finding, std::size_t first) const {
  if (!keep_blobs(finding)) return std::nullopt;
  change_paths(finding, [&](const fs::path& path) {
    const fs::path below = path.lexically_relative(root_);
    return below.empty() || *below.begin() == ".." ? path : below;
  });
  json results = json::array();
  for (const auto& [block, result] : finding.results) {
    const auto seconds = finding.seconds.find(block);
    results.push_back(
        {block - first, result, seconds == finding.seconds.end() ? 0 : seconds->second});
  }
  json pages = json::array();
  for (const auto& [block, page] : finding.pages) pages.push_back({block - first, page});
  std::string bytes = to_cbor({{"results", std::move(results)},
                               {"pages", std::move(pages)},
                               {"model", finding.model_page},
                               {"work", finding.work}});
  change_paths(finding, [&](const fs::path& path) { return root_ / path; });
  return bytes;
}

std::optional<Finding> ResultCodec::decode(const std::string& bytes, std::size_t first) const {
  const std::optional<json> all = from_cbor(bytes);
  if (!all) return std::nullopt;
  Finding finding;
  try {
    for (const json& one : all->at("results")) {
      const std::size_t block = first + one.at(0).get<std::size_t>();
      finding.results[block] = one.at(1).get<Result>();
      finding.seconds[block] = one.at(2).get<double>();
    }
    for (const json& one : all->at("pages")) {
      finding.pages[first + one.at(0).get<std::size_t>()] = one.at(1).get<PageRun>();
    }
    finding.model_page = all->at("model").get<std::optional<ModelPage>>();
    finding.work = all->at("work").get<double>();
  } catch (const json::exception&) {
    return std::nullopt;  // whatever it is, it is no finding
  }
  change_paths(finding, [&](const fs::path& path) { return root_ / path; });
  return keep_blobs(finding) ? std::optional(std::move(finding)) : std::nullopt;
}

std::string fingerprint_of(const Records& records) {
  return sha256(to_cbor(records));
}

}  // namespace mjcourse
