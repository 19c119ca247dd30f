// A model, an example and an exercise: one file each.
// Tested by tests/generator/cli/new_part_test.cpp.
#include <re2/re2.h>

#include <algorithm>
#include <cctype>

#include "base/nearest.h"
#include "base/plain_name.h"
#include "cli/new_part.h"
#include "cli/skeleton.h"
#include "course/course.h"
#include "course/lesson_name.h"
#include "process/our_command.h"

namespace mjcourse {
namespace {

// `word` without the folder and the ending that it has as a file.
std::string bare_name(std::string word, const std::string& folder, const std::string& ending) {
  if (word.starts_with(folder)) word.erase(0, folder.size());
  if (word.ends_with(ending)) word.erase(word.size() - ending.size());
  return word;
}

// The name of a `kind` ("model"), by which lessons call it.
tl::expected<std::string, Refusal> name_of(const std::string& kind, const std::string& folder,
                                           const std::string& ending,
                                           const std::vector<std::string>& words,
                                           const std::string& form) {
  if (words.empty()) return wrong_words("new " + kind + " needs a name", "as in " + form);
  // A model may lie in a folder of its own, with what it is made of.
  static const RE2 plain("[a-z][a-z0-9_]*"),
      in_folders("(?:[a-z0-9][a-z0-9_-]*/)*[a-z0-9][a-z0-9_]*");
  const RE2& good = kind == "model" ? in_folders : plain;
  std::string name = bare_name(words[0], folder, ending);
  if (RE2::FullMatch(name, good)) {
    const auto fault = fault_of_path(name);
    if (!fault) return name;
    return wrong_words(fault->text(), "choose another name, as in " + form);
  }
  std::string likely = slug_of(name);
  std::replace(likely.begin(), likely.end(), '-', '_');
  return wrong_words(
      "`" + words[0] + "` is not a name for " + (kind == "model" ? "a " : "an ") + kind,
      "small letters, digits and underscores, as in " + form +
          (RE2::FullMatch(likely, good) ? "; did you mean `" + likely + "`?" : ""));
}

// The model that a program begins with: the one that was named, the one that is called as the
// program is, or the first.
tl::expected<std::string, Refusal> model_for(const Files& course, const std::string& example,
                                             const std::vector<std::string>& words) {
  const std::vector<std::string> models = model_names(course);
  const auto has = [&](const std::string& name) {
    return std::find(models.begin(), models.end(), name) != models.end();
  };
  if (words.size() > 1) {
    const std::string model = bare_name(words[1], "models/", ".xml");
    if (has(model)) return model;
    return wrong_course("there is no model " + model + " in models/", suggest(model, models));
  }
  if (has(example)) return example;
  if (!models.empty()) return models.front();
  return wrong_course("there is no model that " + example + " could load",
                      our_command("new model NAME") + " makes one");
}

struct NamedProgram {
  std::string name, model;
};

// Of a `kind` ("example") that is a program.
tl::expected<NamedProgram, Refusal> named_program(const std::string& kind, const Files& course,
                                                  const std::vector<std::string>& words) {
  const std::string form = our_command("new " + kind + " l2_1_forces") + " or " +
                           our_command("new " + kind + " l2_1_forces MODEL");
  const auto name = name_of(kind, "examples/", ".cpp", words, form);
  if (!name) return tl::unexpected(name.error());
  if (words.size() > 2) {
    return wrong_words("new " + kind + " takes a name and a model, not `" + words[2] + "`",
                       "as in " + form);
  }
  const auto model = model_for(course, *name, words);
  if (!model) return tl::unexpected(model.error());
  return NamedProgram{*name, *model};
}

}  // namespace

NewPartOrRefusal new_model(const Files& assets, const std::vector<std::string>& words) {
  const std::string form = our_command("new model pendulum");
  const auto name = name_of("model", "models/", ".xml", words, form);
  if (!name) return tl::unexpected(name.error());
  if (words.size() > 1) {
    return wrong_words("new model takes a name, not `" + words[1] + "`", "as in " + form);
  }
  return NewPart{
      {{"models/" + *name + ".xml", filled_skeleton(assets, "model.xml", {{"name", *name}})}},
      "",
      "a lab shows it with `\"model\": \"" + *name +
          "\"`, and a program loads it with "
          "`load_model(\"" +
          *name + "\")`"};
}

NewPartOrRefusal new_example(const Files& course, const Files& assets,
                             const std::vector<std::string>& words) {
  const auto named = named_program("example", course, words);
  if (!named) return tl::unexpected(named.error());
  const auto& [name, model] = *named;
  return NewPart{{{"examples/" + name + ".cpp",
                   filled_skeleton(assets, "example.cpp", {{"name", name}, {"model", model}})}},
                 "",
                 "it loads models/" + model +
                     ".xml; a lesson runs it with a fence "
                     "`cpp file=examples/" +
                     name + ".cpp`, and " + our_command("accept") +
                     " writes what it prints into an empty `text` fence below"};
}

NewPartOrRefusal new_exercise(const Files& course, const Files& assets,
                              const std::vector<std::string>& words) {
  const auto named = named_program("exercise", course, words);
  if (!named) return tl::unexpected(named.error());
  const auto& [name, model] = *named;
  return NewPart{{{"examples/" + name + ".cpp",
                   filled_skeleton(assets, "exercise.cpp", {{"name", name}, {"model", model}})}},
                 "",
                 "a lesson asks for it with an empty fence `cpp exercise file=examples/" + name +
                     ".cpp#answer` in an `[!exercise]`, and " + our_command("check") +
                     " proves its starter, its solution and its wrong variants"};
}

}  // namespace mjcourse
