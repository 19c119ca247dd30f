#include "preview/sent_pages.h"

#include <algorithm>

#include "base/content_hash.h"

namespace mjcourse {
namespace {

// Some for each tab that an author has open; a browser without its page gets it as a whole.
constexpr std::size_t kMost = 40;

}  // namespace

std::string SentPages::keep(const std::string& html) {
  std::string hash = content_hash(html);
  const std::lock_guard lock(mutex_);
  std::erase_if(pages_, [&](const Page& page) { return page.hash == hash; });
  pages_.push_back({hash, html});
  if (pages_.size() > kMost) pages_.pop_front();
  return hash;
}

std::optional<std::string> SentPages::find(const std::string& hash) const {
  const std::lock_guard lock(mutex_);
  const auto page = std::ranges::find(pages_, hash, &Page::hash);
  return page == pages_.end() ? std::nullopt : std::optional(page->html);
}

}  // namespace mjcourse
