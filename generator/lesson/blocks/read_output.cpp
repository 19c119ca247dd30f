#include "lesson/blocks/read_output.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/nearest.h"

namespace mjcourse {
namespace {

// The list in which a block that prints has those that state its output; null for another block.
std::vector<std::size_t>* outputs_of(Block& block) {
  if (auto* example = std::get_if<Example>(&block)) return &example->outputs;
  if (auto* snippet = std::get_if<Snippet>(&block)) return &snippet->outputs;
  if (auto* commands = std::get_if<Commands>(&block)) return &commands->outputs;
  return nullptr;
}

// The block that prints and that `node` stands for; nothing where it is none.
std::optional<std::size_t> printing(cmark_node* node, Lesson& lesson) {
  const auto found = node != nullptr ? lesson.block_of.find(node) : lesson.block_of.end();
  if (found == lesson.block_of.end()) return std::nullopt;
  const bool prints = outputs_of(lesson.blocks[found->second]) != nullptr;
  return prints ? std::optional(found->second) : std::nullopt;
}

// The block of the example `name` above; nothing (reported) when there is none.
std::optional<std::size_t> example_named(const LocatedText& name, const Lesson& lesson,
                                         Reading& reading) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* example = std::get_if<Example>(&lesson.blocks[i]);
    if (example == nullptr) continue;
    if (example->name() == name.text) return i;
    known.push_back(example->name());
  }
  reading.error("E-output-stray", name.span(), "there is no example `" + name.text + "` above",
                known.empty() ? "write its `cpp file=…` fence first" : suggest(name.text, known));
  return std::nullopt;
}

}  // namespace

void read_output(cmark_node* node, const Fence& fence, Lesson& lesson, Reading& reading) {
  cmark_node* above = cmark_node_previous(node);
  const bool labelled = above != nullptr && plain_text(above) == "Output:";
  const std::optional<std::size_t> just_above =
      printing(labelled ? cmark_node_previous(above) : above, lesson);
  std::optional<std::size_t> example = just_above;
  if (const auto named = fence.option("output")) {
    example = example_named(*named, lesson, reading);
    if (!example) return;
  }
  if (!example) {
    reading.error(
        "E-output-stray", fence.span(), "this output belongs to no program",
        "put it right after a `cpp file=…`, `cpp snippet` or `sh run` fence, or name the example "
        "above: `text output=NAME`");
    return;
  }
  const std::optional<double> tolerance = fence.number("tol", reading);
  fence.finish("text", fences::kOutput, reading);
  outputs_of(lesson.blocks[*example])->push_back(lesson.blocks.size());
  const Block* block_above = above != nullptr ? lesson.block(above) : nullptr;
  const auto* other = block_above != nullptr ? std::get_if<Output>(block_above) : nullptr;
  const bool below_another = other != nullptr && other->example == example && !other->apart;
  lesson.add(node, Output{fence.body(), tolerance, *example, fence.span(),
                          example != just_above && !below_another});
  if (labelled) lesson.add(above, Shown{});
}

}  // namespace mjcourse
