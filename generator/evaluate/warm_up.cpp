#include "evaluate/warm_up.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "process/sandbox.h"
#include "toolchain/compiler.h"
#include "toolchain/include_folders.h"
#include "toolchain/warm_header.h"

namespace mjcourse {

void warm_up(const Course& course, const EvaluationSettings& settings) {
  if (sandbox_level().landlock == 0 && !settings.without_landlock) return;  // nothing is run
  const DiskFiles files(settings.root);
  const std::filesystem::path examples = settings.root / "examples";
  const IncludeFolders include = include_folders_of(examples, settings.helper);
  std::set<std::vector<std::string>> all;
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks) {
      const auto* exercise = std::get_if<Exercise>(&block);
      const auto* example = exercise != nullptr ? &exercise->program : std::get_if<Example>(&block);
      const auto program =
          example != nullptr ? files.read(example->file.text) : tl::unexpected(std::string());
      if (program) all.insert(warm_roots(*program, include));
    }
  }
  if (all.empty()) return;
  const std::optional<Compiler> compiler = Compiler::find(include, settings.prepared);
  if (!compiler || !compiler->makes_headers()) return;
  for (const std::vector<std::string>& roots : all) {
    if (!compiler->has_header(roots)) compiler->make_header(roots, Warmth::quick);
  }
}

}  // namespace mjcourse
