#include "lesson/blocks/read_unchecked.h"

namespace mjcourse {

const std::vector<std::string>& unchecked_languages() {
  static const std::vector<std::string> languages{"sh",   "cmake", "python",
                                                  "yaml", "json",  "markdown"};
  return languages;
}

bool is_unchecked(const Fence& fence) {
  return fence.words().size() > 1 && fence.words()[1].text == "unchecked";
}

Unchecked read_unchecked(Fence& fence, Reading& reading) {
  const std::string language = fence.words()[0].text;
  const std::string because = fence.option("because").value_or(LocatedText{}).text;
  fence.finish(language + " unchecked", fences::kUnchecked, reading);
  return {fence.body(), language, because, fence.span()};
}

void refuse_plain(const Fence& fence, Reading& reading) {
  const std::string language = fence.words()[0].text;
  std::vector<std::string> kinds{"unchecked"};
  if (language == "sh") kinds.insert(kinds.begin(), "run");
  if (fence.refuse_second_word(kinds, reading)) return;
  reading.error("E-fence-kind", fence.span(),
                "a plain `" + language + "` fence would show code that nobody ran",
                (language == "sh" ? "let it run: `sh run`; or say that nobody does, and why: `"
                                  : "say so, and why: `") +
                    language + " unchecked because=\"…\"`");
}

}  // namespace mjcourse
