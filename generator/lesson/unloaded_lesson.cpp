#include "lesson/unloaded_lesson.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/content_hash.h"
#include "lesson/read_lesson.h"

namespace mjcourse {
namespace {

bool is_prose(const Block& block) {
  return std::holds_alternative<Unchecked>(block) || std::holds_alternative<Callout>(block) ||
         std::holds_alternative<Io>(block) || std::holds_alternative<Demo>(block) ||
         std::holds_alternative<Shown>(block);
}

// MuJoCo's names and models have pages that say who links to them.
bool is_explained(const Link& link) {
  return link.target.text.starts_with("api:") || link.target.text.starts_with("model:");
}

// The lesson's bytes as they were; from the file where the unloaded lesson has none.
std::string bytes_of(const Lesson& unloaded, const Files& files) {
  const std::string& path = unloaded.source->path();
  if (unloaded.kept != Lesson::Kept::outline) return std::string(unloaded.source->text());
  tl::expected<std::string, std::string> bytes = files.read(path);
  if (!bytes) throw std::runtime_error("cannot read again " + bytes.error());
  if (content_hash(*bytes) != unloaded.hash) {
    throw std::runtime_error(path + " was changed while it was worked on; begin again");
  }
  return *std::move(bytes);
}

}  // namespace

bool is_prose(const Lesson& lesson) {
  return std::all_of(lesson.blocks.begin(), lesson.blocks.end(),
                     [](const Block& block) { return is_prose(block); }) &&
         std::none_of(lesson.links.begin(), lesson.links.end(), is_explained);
}

// Where `= {}` would keep a container's memory, a new one is moved in.
void unload(Lesson& lesson, Lesson::Kept kept) {
  lesson.kept = kept;
  lesson.document.reset();
  lesson.block_of = decltype(lesson.block_of)();
  lesson.front.summary.reset();
  lesson.front.objectives.clear();
  for (Heading& heading : lesson.headings) heading.node = nullptr;
  for (Link& link : lesson.links) link.node = nullptr;
  if (kept != Lesson::Kept::outline) return;
  lesson.unchecked = static_cast<int>(
      std::count_if(lesson.blocks.begin(), lesson.blocks.end(),
                    [](const Block& block) { return std::holds_alternative<Unchecked>(block); }));
  lesson.hash = content_hash(lesson.source->text());
  lesson.length = lesson.source->text().size();
  lesson.source = std::make_shared<SourceText>(lesson.source->path(), "");
  lesson.blocks = std::vector<Block>();
  lesson.front.tags.clear();
  for (Heading& heading : lesson.headings) heading.title = std::vector<TitlePart>();
  lesson.headings.shrink_to_fit();
}

void forget_links(Lesson& lesson) {
  if (lesson.kept == Lesson::Kept::outline) lesson.links = std::vector<Link>();
}

Lesson reload(const Lesson& unloaded, const Files& files) {
  Diagnostics known;  // they were told when it was first read
  std::optional<Lesson> whole =
      read_lesson(unloaded.source->path(), bytes_of(unloaded, files), known, unloaded.typography);
  whole->index = unloaded.index;
  return *std::move(whole);
}

}  // namespace mjcourse
