#include "evaluate/programs/snippet_text.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace mjcourse {
namespace {

constexpr std::size_t kHiddenMarkSize = 4;  // of "//| "

constexpr const char* kFunctionHead = R"(
void snippet([[maybe_unused]] mjModel* model, [[maybe_unused]] mjData* data) {
)";
// Around the model's name.
constexpr const char* kMainToModel = R"(}

int main() {
  char error[1000] = "";
  mjModel* model = mj_loadXML(MJCOURSE_MODELS "/)";
constexpr const char* kMainFromModel = R"(.xml", nullptr, error, sizeof error);
  if (model == nullptr) {
    std::fprintf(stderr, "%s\n", error);
    return 1;
  }
  mjData* data = mj_makeData(model);
  snippet(model, data);
  mj_deleteData(data);
  mj_deleteModel(model);
}
)";

// Takes the first line off `text`.
std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

// `line`, in which blanks took the place of `//| `.
std::string_view without_mark(std::string_view line) {
  return line.substr(std::min({line.find_first_not_of(' '), line.size(), kHiddenMarkSize}));
}

// The lines of the snippet, those too that the lesson hides.
std::string body_of(const Snippet& snippet) {
  std::string_view code = snippet.code.text, shown = snippet.shown;
  // A raw string may go over lines, and what is put in front of them would be a part of it.
  const char* const indent = code.find("R\"") == code.npos ? "  " : "";
  std::string text;
  while (!code.empty()) {
    std::string_view line = take_line(code);
    if (line == shown.substr(0, shown.find('\n'))) {
      take_line(shown);
    } else {
      line = without_mark(line);
    }
    if (line.find_first_not_of(" \t") != line.npos) text.append(indent).append(line);
    text += '\n';
  }
  return text;
}

}  // namespace

std::string snippet_text(const Snippet& snippet, const std::string& prelude) {
  return prelude + kFunctionHead + body_of(snippet) + kMainToModel + snippet.model.text +
         kMainFromModel;
}

}  // namespace mjcourse
