#include "evaluate/shared_headers.h"

#include <map>
#include <utility>

#include "base/counted.h"

namespace mjcourse {
namespace {

constexpr std::size_t kFewPrograms = 2, kManyPrograms = 40;

}  // namespace

std::string SharedHeaders::Header::what() const {
  return "compile once what " + counted(programs, "program") + " include";
}

SharedHeaders::SharedHeaders(const Setting& setting, const std::vector<const Task*>& waiting)
    : setting_(setting) {
  if (waiting.empty() || !setting.compiler() || !setting.compiler()->makes_headers()) return;
  std::map<std::vector<std::string>, std::size_t> programs;
  for (const Task* task : waiting) {
    const std::vector<std::string> roots = task->warm_roots(setting);
    if (!roots.empty()) ++programs[roots];
  }
  for (const auto& [roots, count] : programs) {
    if (count < kFewPrograms || setting.compiler()->has_header(roots)) continue;
    headers_.push_back({roots, count < kManyPrograms ? Warmth::quick : Warmth::thorough, count});
  }
}

std::optional<SharedHeaders::Header> SharedHeaders::next() {
  const std::lock_guard lock(mutex_);
  if (headers_.empty()) return std::nullopt;
  Header header = std::move(headers_.back());
  headers_.pop_back();
  return header;
}

void SharedHeaders::make(const Header& header) const {
  setting_.compiler()->make_header(header.roots, header.warmth);
}

}  // namespace mjcourse
