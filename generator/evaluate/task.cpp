#include "evaluate/task.h"

#include <variant>

#include "base/any_of.h"

namespace mjcourse {
namespace {

struct SpanOf {
  Span operator()(const InlineValue& value) const { return value.source.span(); }
  Span operator()(const Math& math) const { return math.tex.span(); }
  Span operator()(const Image& image) const { return image.file.span(); }
  Span operator()(const Quiz& quiz) const {
    return quiz.questions.empty() ? Span{} : quiz.questions.front().span;
  }
  template <typename Fence>
    requires requires(const Fence& fence) { fence.span; }
  Span operator()(const Fence& fence) const {
    return fence.span;
  }
  template <AnyOf<TermUse, Io, Demo, Shown> Other>
  Span operator()(const Other&) const {
    return {};
  }
};

}  // namespace

Place Task::place() const {
  const std::vector<Block>& blocks = lesson_.blocks;
  return place_of(*lesson_.source, blocks.empty() ? Span{} : std::visit(SpanOf{}, blocks[block_]));
}

}  // namespace mjcourse
