#include "lesson/blocks/read_code.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "base/nearest.h"
#include "base/plain_name.h"
#include "base/text_lines.h"

namespace mjcourse {
namespace {

// "expect=exit:3", "expect=compile-error".
void read_expectation(Fence& fence, Example& example, Reading& reading) {
  const std::optional<LocatedText> expect = fence.option("expect");
  if (!expect) return;
  if (expect->text == "compile-error") {
    example.compiles = false;
    return;
  }
  constexpr std::string_view start = "exit:";
  if (!expect->text.starts_with(start)) {
    reading.error(
        "E-fence-option", expect->span(), "`expect` has no such value",
        suggest(expect->text, {fences::kProgramEnds.begin(), fences::kProgramEnds.end()}));
    return;
  }
  int code = 0;
  const char* end = expect->text.data() + expect->text.size();
  const auto [stop, failure] = std::from_chars(expect->text.data() + start.size(), end, code);
  if (failure == std::errc() && stop == end && code >= 0 && code < 256) {
    example.exit_code = code;
    return;
  }
  reading.error("E-fence-option", expect->span(), "an exit code is a whole number from 0 to 255",
                "write it as `expect=exit:1`");
}

void read_arguments(Fence& fence, Example& example) {
  std::istringstream words(fence.option("args").value_or(LocatedText{}).text);
  for (std::string word; words >> word;) example.arguments.push_back(word);
}

// "native", "native because=…"
void read_native(Fence& fence, std::string& why, Reading& reading) {
  const bool native = fence.flag("native");
  const std::optional<LocatedText> because = fence.option("because");
  if (native) why = because ? because->text : "native only";
  if (native || !because) return;
  reading.error("E-fence-option", because->span(), "this program has nothing to be excused",
                "`native because=\"…\"` says why no page runs it");
}

void read_run(Fence& fence, Example& example, Reading& reading) {
  example.seconds =
      fence.number("timeout", reading, fences::kMostSeconds).value_or(example.seconds);
  example.optimize = fence.flag("optimize");
  read_arguments(fence, example);
  read_native(fence, example.native, reading);
}

// Cut `#name` off the end of `file`.
std::optional<LocatedText> take_region(LocatedText& file) {
  const std::size_t mark = file.text.rfind('#');
  if (mark == file.text.npos) return std::nullopt;
  LocatedText region = file.part(mark + 1, file.text.size());
  file = file.part(0, mark);
  return region;
}

// Report `file` where it is not the file of a program, which is `what`.
bool is_example_file(const LocatedText& file, const std::string& what, Reading& reading) {
  const std::string& path = file.text;
  std::string why;
  if (path.starts_with("examples/") && path.ends_with(".cpp")) {
    const auto fault = fault_of_path(path);
    if (!fault) return true;
    why = ", and " + fault->text();
  }
  reading.error("E-example-file", file.span(), what + " is a file `examples/NAME.cpp`" + why,
                why.empty() ? "" : "give the file a name of letters, digits, `-`, `_` and dots");
  return false;
}

std::optional<Example> read_example(Fence& fence, Reading& reading) {
  std::optional<LocatedText> file = fence.option("file");
  if (!file) {
    const bool plain = fence.flag("optimize");  // an option of programs
    if (!plain &&
        fence.refuse_second_word({"exercise", "snippet", "file=NAME", "unchecked"}, reading)) {
      return std::nullopt;
    }
    reading.error("E-fence-kind", fence.span(),
                  "a plain `cpp` fence would show code that nobody ran",
                  "name the program's file: `cpp file=examples/NAME.cpp`; or let it be the body of "
                  "a function: `cpp snippet model=NAME`; or say that nobody runs it, and why: "
                  "`cpp unchecked because=\"…\"`");
    return std::nullopt;
  }
  const std::optional<LocatedText> region = take_region(*file);
  if (!is_example_file(*file, "an example", reading)) return std::nullopt;
  Example example{*file, region, fence.body()};
  example.span = fence.span();
  if (region) {
    fence.finish("cpp", fences::kRegion, reading);
    return example;
  }
  read_run(fence, example, reading);
  read_expectation(fence, example, reading);
  fence.finish("cpp", fences::kProgram, reading);
  return example;
}

std::optional<Exercise> read_exercise(Fence& fence, Reading& reading) {
  std::optional<LocatedText> file = fence.option("file");
  const std::optional<LocatedText> region = file ? take_region(*file) : std::nullopt;
  if (!region || region->text.empty()) {
    reading.error("E-fence-kind", file ? file->span() : fence.span(),
                  "an exercise is a region of a program, which its reader writes",
                  "name both: `cpp exercise file=examples/NAME.cpp#REGION`");
    return std::nullopt;
  }
  if (!is_example_file(*file, "an exercise", reading)) return std::nullopt;
  Exercise exercise{Example{*file, region, {}}, fence.option("hidden"), fence.span()};
  if (exercise.hidden &&
      !is_example_file(*exercise.hidden, "a program of hidden checks", reading)) {
    return std::nullopt;
  }
  exercise.program.span = fence.span();
  read_run(fence, exercise.program, reading);
  if (!trimmed(fence.body().text).empty()) {
    reading.error("E-exercise-body", fence.body().span(),
                  "the fence of an exercise is empty: its text is the file's",
                  "write the starter in " + file->text + ", below a line `// #starter`");
  }
  fence.finish("cpp exercise", fences::kExercise, reading);
  return exercise;
}

// A line that begins with `//| ` is compiled and not shown. Spaces take the place of the mark, so
// that columns stay.
void hide_lines(Snippet& snippet) {
  constexpr std::string_view mark = "//|";
  std::string& code = snippet.code.text;
  for (std::size_t at = 0; at < code.size();) {
    const std::size_t end = std::min(code.find('\n', at), code.size() - 1) + 1;
    const std::size_t first = std::min(code.find_first_not_of(" \t", at), end);
    if (code.compare(first, mark.size(), mark) == 0) {
      code.replace(first, mark.size(), mark.size(), ' ');
    } else {
      snippet.shown += code.substr(at, end - at);
    }
    at = end;
  }
}

std::optional<Snippet> read_snippet(Fence& fence, Reading& reading) {
  const std::optional<LocatedText> model = fence.option("model");
  if (!model) {
    reading.error("E-fence-kind", fence.span(), "a snippet says which model it is about",
                  "write `cpp snippet model=NAME`");
    return std::nullopt;
  }
  Snippet snippet{*model, fence.body(), ""};
  snippet.span = fence.span();
  snippet.seconds =
      fence.number("timeout", reading, fences::kMostSeconds).value_or(snippet.seconds);
  read_native(fence, snippet.native, reading);
  hide_lines(snippet);
  if (snippet.shown.find_first_not_of(" \n") == std::string::npos) {
    reading.error("E-snippet-empty", fence.span(), "this snippet shows nothing",
                  "write a line that does not begin with `//| `");
  }
  fence.finish("cpp snippet", fences::kSnippet, reading);
  return snippet;
}

}  // namespace

std::string Example::name() const {
  const std::size_t slash = file.text.rfind('/') + 1;
  return file.text.substr(slash, file.text.rfind('.') - slash);
}

std::optional<Block> read_code(Fence& fence, Reading& reading) {
  const std::string kind = fence.words().size() > 1 ? fence.words()[1].text : "";
  if (kind == "snippet") return read_snippet(fence, reading);
  if (kind == "exercise") return read_exercise(fence, reading);
  return read_example(fence, reading);
}

}  // namespace mjcourse
