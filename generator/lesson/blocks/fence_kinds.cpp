#include "lesson/blocks/fence_kinds.h"

#include <algorithm>
#include <vector>

#include "lesson/blocks/read_unchecked.h"
#include "lesson/json/json_fences.h"

namespace mjcourse {

std::span<const FenceKind> fence_kinds() {
  static const std::vector<FenceKind> all = [] {
    std::vector<FenceKind> kinds{
        {"cpp", "a program, compiled and run", fences::kProgram},
        {"cpp exercise", "a program of which the reader writes a region", fences::kExercise},
        {"cpp snippet", "the body of a function, compiled and run", fences::kSnippet},
        {"sh run", "commands, run in a folder of their own", fences::kCommands},
        {"xml", "lines of a model, held against its file", fences::kExcerpt},
        {"xml mjcf", "a model, compiled", fences::kInlineModel},
        {"text", "what the program above prints, held against that", fences::kOutput},
        {"io", "a panel: input, process, output"}};
    for (const JsonFence& fence : json_fences()) {
      kinds.push_back({std::string(fence.opened), "JSON of its keys"});
    }
    kinds.push_back({"demo", "a piece of a lesson, as it is written and as what it becomes"});
    std::vector<std::string> shown = unchecked_languages();
    shown.insert(shown.end(), {"cpp", "xml", "text"});
    for (const std::string& language : shown) {
      kinds.push_back({language + " unchecked", "code that nobody runs", fences::kUnchecked});
    }
    return kinds;
  }();
  return all;
}

const FenceKind* find_fence_kind(std::string_view words) {
  const auto kinds = fence_kinds();
  const auto found = std::ranges::find(kinds, words, &FenceKind::words);
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace mjcourse
