#include "page/page_renderer.h"

#include <ostream>
#include <utility>

#include "base/content_hash.h"
#include "course/language.h"
#include "page/course_data.h"
#include "page/html/page_fonts.h"
#include "page/html/placeholder.h"
#include "page/site_data.h"
#include "page/web_place.h"
#include "script/script_bundles.h"

namespace mjcourse {
namespace {

// Of a page that may be shown anywhere, the assets are looked for in its folder and in those above.
// What is not there costs a request that fails, so there are not more of them than folders of a
// site.
nlohmann::json roots_of(const PageHead& head) {
  if (!head.anywhere) return nlohmann::json::array({head.root});
  return nlohmann::json::array({"", "../", "../../", "../../../"});
}

// A course with a style of its own may have other faces, and a page that may be shown anywhere does
// not know where they are.
nlohmann::json fonts_of(const PageHead& head, const SiteData& site, const std::string& body) {
  nlohmann::json fonts = nlohmann::json::array();
  if (head.anywhere || !site.theme.empty()) return fonts;
  for (const std::string_view name : page_fonts(body)) {
    if (const auto font = site.manifest.find(name); font != site.manifest.end()) {
      fonts.push_back(head.root + font->get<std::string>());
    }
  }
  return fonts;
}

}  // namespace

PageEngines::PageEngines(const Files& assets, std::size_t memory, const RendererOf& renderer_of)
    : templates(site_templates(assets, memory, renderer_of)),
      highlighter(script_bundle(assets, "highlight"), memory) {}

PageContext PageRenderer::context(InlineStyles& styles, const std::string& path) {
  return {engines_.templates, engines_.highlighter, site_.manifest,       styles,         path,
          &site_.definitions, site_.places,         site_.compiler_bytes, site_.solutions};
}

void PageRenderer::write(const std::string& path, const PageHead& head, const std::string& body,
                         InlineStyles& styles) {
  const std::string styled = styles.take(body);
  std::string html = frame(path, head, styled, styles);
  fill_in(html, "page", "body", "body", styled);
  directory_.write(path, html);
}

void PageRenderer::write_long(const std::string& path, const PageHead& head,
                              const std::string& body, const std::vector<PagePart>& parts,
                              Spool& spool) {
  // The head names the stylesheet, so all styles are taken before anything is written.
  InlineStyles styles;
  std::vector<PagePart> styled = parts;
  for (PagePart& part : styled) {
    for (Spool::Piece& piece : part.pieces) piece = spool.put(styles.take(spool.get(piece)));
  }
  std::string html = frame(path, head, body, styles);
  fill_in(html, "page", "body", "body", body);
  directory_.write(path, [&](std::ostream& file) {
    std::size_t at = 0;
    for (const PagePart& part : styled) {
      const std::size_t mark = html.find(part.mark, at);
      if (mark == html.npos) continue;  // nothing of this kind is on the page
      file << std::string_view(html).substr(at, mark - at);
      for (const Spool::Piece& piece : part.pieces) file << spool.get(piece);
      at = mark + part.mark.size();
    }
    file << std::string_view(html).substr(at);
  });
}

// The page around `body`. What its elements have of styles is written beside it.
std::string PageRenderer::frame(const std::string& path, const PageHead& head,
                                const std::string& body, const InlineStyles& styles) {
  std::string sheet;
  if (!styles.sheet().empty()) {
    sheet = "styles/" + content_hash(styles.sheet()) + ".css";
    directory_.write(sheet, styles.sheet());
  }
  const Course& course = site_.course;
  nlohmann::json levels = levels_data(course, head.current);
  const bool more = levels.size() < course.levels.size();
  return render_template(engines_.templates, "page",
                         {{"course",
                           {{"title", course.title},
                            {"description", course.description},
                            {"language", course.language},
                            {"right_to_left", is_right_to_left(course.language)}}},
                          {"page",
                           {{"title", head.title},
                            {"description", head.description},
                            {"kind", head.kind},
                            {"home", head.kind == "home"}}},
                          {"theme", site_.theme},
                          {"fonts", fonts_of(head, site_, body)},
                          {"place", web_place(site_, path, head)},
                          {"root", head.root},
                          {"roots", roots_of(head)},
                          {"assets",
                           {{"css", site_.manifest.at("site.css")},
                            {"js", site_.manifest.at("site.js")},
                            {"listing", site_.manifest.at("listing.js")},
                            {"reading", site_.manifest.at("reading.js")},
                            {"offline", site_.places ? "" : site_.manifest.at("offline.js")},
                            {"favicon", site_.manifest.at("favicon.svg")}}},
                          {"styles", sheet},
                          {"levels", std::move(levels)},
                          {"more", more},
                          {"pages", pages_data(course, site_.evaluation, site_.asks, head.kind)},
                          {"body", placeholder("body")}});
}

}  // namespace mjcourse
