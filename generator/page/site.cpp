#include "page/site.h"

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "page/blocks/program_data.h"
#include "page/blocks/themed_assets.h"
#include "page/edition_manifest.h"
#include "page/precompressed.h"
#include "page/site_data.h"
#include "page/site_directory.h"
#include "page/site_pages.h"
#include "page/template_process.h"
#include "page/template_time.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

void copy_assets(const fs::path& folder, const std::set<std::string>& unused,
                 SiteDirectory& directory) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().lexically_relative(folder);
    if (entry.is_regular_file() && !unused.contains(path)) directory.copy_own(entry.path(), path);
  }
}

}  // namespace

void write_site(const Course& course, const Evaluation& evaluation, const SitePaths& paths,
                const OutlineClaims& claims_of_outline, LastChanges changes) {
  const ThemedAssets assets(paths.assets, {paths.course / kThemeTemplates});
  SiteDirectory directory(paths.out, paths.course);
  SitePages pages(course, evaluation, paths.course, assets, directory, false, std::move(changes),
                  claims_of_outline);
  if (!paths.solutions) pages.withhold_solutions();
  const RendererOf renders = within(time_of_templates(course.lessons.size()),
                                    renderer_of(assets, paths.program, paths.assets));
  // Made on the thread that works with it, at its first page.
  std::vector<std::unique_ptr<PageEngines>> engines(paths.threads);
  const auto engines_of = [&](std::size_t thread) -> PageEngines& {
    if (!engines[thread]) {
      engines[thread] = std::make_unique<PageEngines>(assets, kLittleMemory, renders);
    }
    return *engines[thread];
  };
  for_each_index(course.lessons.size(), paths.threads, [&](std::size_t index, std::size_t thread) {
    if (!course.lessons[index].front.draft) pages.write_lesson(index, engines_of(thread));
  });
  pages.write_others(engines_of(0));
  copy_assets(paths.assets / "public", unused_assets(evaluation, assets), directory);
  write_edition(directory.folder(), course, assets, paths.threads);
  if (paths.compress) precompress(directory.folder(), paths.threads);
  if (evaluation.open_in_page > 0) directory.write(kProvisional, "");
  directory.commit();
}

}  // namespace mjcourse
