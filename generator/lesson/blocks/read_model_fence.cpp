#include "lesson/blocks/read_model_fence.h"

#include "base/nearest.h"

namespace mjcourse {
namespace {

std::optional<Block> read_inline_model(Fence& fence, Reading& reading) {
  InlineModel model{fence.body(), true, fence.span()};
  if (const std::optional<LocatedText> expect = fence.option("expect")) {
    model.compiles = expect->text != "error";
    if (model.compiles) {
      reading.error("E-fence-option", expect->span(), "`expect` has no such value",
                    suggest(expect->text, {fences::kModelEnds.begin(), fences::kModelEnds.end()}));
    }
  }
  fence.finish("xml mjcf", fences::kInlineModel, reading);
  return model;
}

}  // namespace

std::optional<Block> read_model_fence(Fence& fence, Reading& reading) {
  if (fence.words().size() > 1 && fence.words()[1].text == "mjcf") {
    return read_inline_model(fence, reading);
  }
  if (fence.refuse_second_word({"mjcf", "model=NAME", "unchecked"}, reading)) return std::nullopt;
  const std::optional<LocatedText> model = fence.option("model");
  if (!model) {
    reading.error("E-fence-kind", fence.span(),
                  "a plain `xml` fence would show a model that nobody compiled",
                  "name the model that this is a part of: `xml model=NAME`; or let it be a whole "
                  "one: `xml mjcf`; or say that nobody compiles it, and why: "
                  "`xml unchecked because=\"…\"`");
    return std::nullopt;
  }
  fence.finish("xml", fences::kExcerpt, reading);
  return ModelExcerpt{*model, fence.body(), fence.span()};
}

}  // namespace mjcourse
