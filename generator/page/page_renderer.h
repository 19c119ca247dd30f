// PageRenderer: what one thread writes the pages of a site with.
//
// Enter with write(), which puts a body into the frame that all pages have. Script engines serve
// one thread each, so every thread that writes pages has a renderer of its own; what they share
// (site_data.h) they only read.
// Tested by tests/site/policy.mjs.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/spool.h"
#include "course/course.h"
#include "course/last_changed.h"
#include "findings/evaluation.h"
#include "page/blocks/page_writer.h"
#include "page/html/lesson_pictures.h"
#include "page/html/site_files.h"
#include "page/site_data.h"

namespace mjcourse {

// Pieces of a body, which has a mark in their place.
struct PagePart {
  std::string mark;
  std::vector<Spool::Piece> pieces;
};

// The script engines of a renderer, which serve any number of sites one after the other.
struct PageEngines {
  // A caller that writes the same pages again and again gives more `memory`, in bytes for each.
  explicit PageEngines(const Files& assets, std::size_t memory = kLittleMemory,
                       const RendererOf& renderer_of = {});
  Templates templates;
  Highlighter highlighter;
};

class PageRenderer {
 public:
  // All must outlive this.
  PageRenderer(const SiteData& site, SiteFiles& directory, PageEngines& engines)
      : site_(site), directory_(directory), engines_(engines) {}

  // For the page `path`, which needs `styles`.
  PageContext context(InlineStyles& styles, const std::string& path);
  Templates& templates() { return engines_.templates; }

  // Write the page `path` with its stylesheet, if it needs one.
  void write(const std::string& path, const PageHead& head, const std::string& body,
             InlineStyles& styles);

  // The same of a body whose parts, in their order, wait in a spool.
  void write_long(const std::string& path, const PageHead& head, const std::string& body,
                  const std::vector<PagePart>& parts, Spool& spool);

 private:
  std::string frame(const std::string& path, const PageHead& head, const std::string& body,
                    const InlineStyles& styles);

  const SiteData& site_;
  SiteFiles& directory_;
  PageEngines& engines_;
};

}  // namespace mjcourse
