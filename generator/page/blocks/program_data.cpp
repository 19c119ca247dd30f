#include "page/blocks/program_data.h"

#include <algorithm>
#include <string>
#include <utility>

#include "page/html/site_paths.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// Attributes of the listing, and the assets that they lead to.
constexpr std::pair<const char*, const char*> kAssets[] = {
    {"code", "program.js"},   {"style", "program.css"}, {"worker", "cpp.js"},
    {"llvm", "llvm.wasm.xz"}, {"pack", "cpp.pack.xz"},  {"engine", "engine.mjs"},
    {"wasm", "engine.wasm"},  {"lab_style", "lab.css"},
};

// Of these, what is there for the compiler alone.
constexpr const char* kCompiler[] = {"cpp.js", "llvm.wasm.xz", "cpp.pack.xz"};

bool has_compiler(const json& manifest) {
  for (const auto& [attribute, asset] : kAssets) {
    if (!manifest.contains(asset)) return false;
  }
  return true;
}

bool runs_in_page(const ExampleResult& result) {
  return result.page && result.page->why_not.empty();
}

bool any_runs_in_page(const LessonResults& results) {
  return std::ranges::any_of(results.of_block, [](const auto& block) {
    if (const auto* exercise = std::get_if<ExerciseResult>(&block.second)) {
      return exercise->runs_in_page();
    }
    const auto* result = std::get_if<ExampleResult>(&block.second);
    return result != nullptr && runs_in_page(*result);
  });
}

json addresses(const LessonContext& context) {
  json data;
  for (const auto& [attribute, asset] : kAssets) {
    data[attribute] = context.from_root(context.page.manifest.at(asset).get<std::string>());
  }
  return data;
}

// What its outputs say besides the letters that it printed, as JSON; "" where they do not. The page
// compares with them.
std::string stated_outputs(const Example& example, const std::string& printed,
                           const Lesson& lesson) {
  json stated;
  for (const std::size_t index : example.outputs) {
    const auto& output = std::get<Output>(lesson.blocks[index]);
    if (!output.tolerance && output.text.text == printed) continue;
    const json tolerance = output.tolerance ? json(*output.tolerance) : json(nullptr);
    stated.push_back({{"text", output.text.text}, {"tolerance", tolerance}});
  }
  return stated.empty() ? "" : stated.dump();
}

json run_data(const Example& program, const std::string& outputs, const LessonContext& context) {
  json data{{"bytes", context.page.compiler_bytes},
            {"arguments", program.arguments.empty() ? "" : json(program.arguments).dump()},
            {"outputs", outputs},
            {"exit", program.exit_code}};
  data.update(addresses(context));
  return data;
}

}  // namespace

json run_data(const Example& example, const ExampleResult* result, const LessonContext& context) {
  if (program_zip_path(example, result).empty()) return nullptr;
  if (!has_compiler(context.page.manifest)) return nullptr;
  if (!runs_in_page(*result)) return nullptr;
  return run_data(example, stated_outputs(example, result->output, context.lesson), context);
}

json run_data(const Exercise& exercise, const ExerciseResult& result,
              const LessonContext& context) {
  if (!has_compiler(context.page.manifest) || !result.runs_in_page()) return nullptr;
  return run_data(exercise.program, "", context);
}

std::string lab_compiler(const LessonContext& context) {
  if (!any_runs_in_page(context.results) || !has_compiler(context.page.manifest)) return "";
  json data = addresses(context);
  for (const char* own : {"engine", "wasm", "lab_style"}) data.erase(own);
  data["bytes"] = std::to_string(context.page.compiler_bytes);
  return data.dump();
}

json why_not_data(const ExampleResult* result) {
  if (result == nullptr || !result->page || result->page->why_not.empty()) return nullptr;
  return result->page->why_not;
}

json why_not_data(const ExerciseResult& result) {
  if (!result.page || result.runs_in_page()) return nullptr;
  return result.why_not.empty() ? result.page->why_not : result.why_not;
}

std::set<std::string> unused_assets(const Evaluation& evaluation, const Files& assets) {
  if (std::ranges::any_of(evaluation.lessons, any_runs_in_page)) return {};
  const json manifest = json::parse(assets.read("manifest.json").value());
  std::set<std::string> unused;
  for (const char* asset : kCompiler) {
    if (manifest.contains(asset)) unused.insert(manifest.at(asset).get<std::string>());
  }
  return unused;
}

std::size_t compiler_bytes(const Files& assets, const json& manifest) {
  if (!has_compiler(manifest)) return 0;
  std::size_t bytes = 0;
  for (const char* asset : kCompiler) {
    bytes += assets.read("public/" + manifest.at(asset).get<std::string>()).value().size();
  }
  return bytes;
}

}  // namespace mjcourse
