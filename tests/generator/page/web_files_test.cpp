#include "page/web_files.h"

#include <gtest/gtest.h>

#include <map>

#include "page/moved_pages.h"
#include "page/site_of.h"

namespace mjcourse {
namespace {

// Keeps what is written.
class KeptFiles : public SiteFiles {
 public:
  void write(const std::string& path, std::string_view bytes) override { texts[path] = bytes; }
  void write(const std::string&, const std::function<void(std::ostream&)>&) override {}
  void copy(const std::filesystem::path&, const std::string&) override {}
  std::map<std::string, std::string> texts;
};

class WebFiles : public testing::Test {
 protected:
  WebFiles() { site_.course.url = "https://example.org/c/"; }

  std::map<std::string, std::string> written() {
    site_.data.feed = has_feed(site_.data);
    Spool spool;
    std::vector<LessonParts> parts(2);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i].news =
          spool.put(feed_entry(site_.data, site_.course.lessons[i], "A < B", templates_));
    }
    KeptFiles files;
    write_web_files(site_.data, parts, templates_, files, spool);
    return files.texts;
  }

  SiteOf site_;
  Templates templates_ = site_templates(site_.assets);
};

TEST_F(WebFiles, AreNoneWithoutAnAddress) {
  site_.course.url = "";
  site_.data.changes["content/1-a/1.1-x.md"] = {"2026-03-03", "2026-03-03T04:30:00Z"};
  EXPECT_TRUE(written().empty());
}

TEST_F(WebFiles, TellOfNoDocumentThatIsTooLong) {
  EXPECT_NE(written().at("sitemap.xml").find("print.html"), std::string::npos);
  site_.data.prints = false;
  EXPECT_EQ(written().at("sitemap.xml").find("print.html"), std::string::npos);
}

TEST_F(WebFiles, TellOfNoChangeThatNobodyKnows) {
  site_.data.changes["content/1-a/1.1-x.md"] = {};  // not committed
  const auto files = written();
  EXPECT_EQ(files.size(), 3U);
  EXPECT_EQ(files.at("robots.txt"),
            "User-agent: *\nAllow: /\n\nSitemap: https://example.org/c/sitemap.xml\n");
  EXPECT_EQ(files.at("sitemap.xml"),
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
            "<urlset xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n"
            "<url><loc>https://example.org/c/</loc></url>\n"
            "<url><loc>https://example.org/c/1-a/1.1-x.html</loc></url>\n"
            "<url><loc>https://example.org/c/1-a/1.2-y.html</loc></url>\n"
            "<url><loc>https://example.org/c/progress.html</loc></url>\n"
            "<url><loc>https://example.org/c/offline.html</loc></url>\n"
            "<url><loc>https://example.org/c/verification.html</loc></url>\n"
            "<url><loc>https://example.org/c/search.html</loc></url>\n"
            "<url><loc>https://example.org/c/print.html</loc></url>\n"
            "</urlset>\n");
}

TEST_F(WebFiles, TellABrowserOfTheSearch) {
  site_.course.title = "Mechanics & more of it";
  EXPECT_EQ(written().at("opensearch.xml"), R"(<?xml version="1.0" encoding="utf-8"?>
<OpenSearchDescription xmlns="http://a9.com/-/spec/opensearch/1.1/">
<ShortName>Mechanics &amp; more</ShortName>
<Description>Search Mechanics &amp; more of it</Description>
<InputEncoding>UTF-8</InputEncoding>
<Language>en</Language>
<Url type="text/html" template="https://example.org/c/search.html?q={searchTerms}"/>
</OpenSearchDescription>
)");
}

TEST_F(WebFiles, TellOfTheNewestLessonFirst) {
  site_.data.changes["content/1-a/1.1-x.md"] = {"2026-03-03", "2026-03-03T04:30:00Z"};
  site_.data.changes["content/1-a/1.2-y.md"] = {"2026-03-02", "2026-03-03T05:30:00Z"};
  const auto files = written();
  EXPECT_EQ(files.at("feed.xml"), R"(<?xml version="1.0" encoding="utf-8"?>
<feed xmlns="http://www.w3.org/2005/Atom" xml:lang="en">
<id>https://example.org/c/</id>
<title>C</title>
<author><name>C</name></author>
<link rel="alternate" type="text/html" href="https://example.org/c/"/>
<link rel="self" type="application/atom+xml" href="https://example.org/c/feed.xml"/>
<updated>2026-03-03T05:30:00Z</updated>
<entry>
<id>https://example.org/c/1-a/1.2-y.html</id>
<title>1.2 Two</title>
<link rel="alternate" type="text/html" href="https://example.org/c/1-a/1.2-y.html"/>
<updated>2026-03-03T05:30:00Z</updated>
<summary>A &lt; B</summary>
</entry>
<entry>
<id>https://example.org/c/1-a/1.1-x.html</id>
<title>1.1 One</title>
<link rel="alternate" type="text/html" href="https://example.org/c/1-a/1.1-x.html"/>
<updated>2026-03-03T04:30:00Z</updated>
<summary>A &lt; B</summary>
</entry>
</feed>
)");
  EXPECT_NE(files.at("sitemap.xml").find("1.2-y.html</loc><lastmod>2026-03-03T05:30:00Z</lastmod>"),
            std::string::npos);
}

TEST_F(WebFiles, HaveNoDrafts) {
  site_.data.changes["content/1-a/1.2-y.md"] = {"2026-03-02", "2026-03-03T05:30:00Z"};
  site_.course.lessons[1].front.draft = true;
  const auto files = written();
  EXPECT_FALSE(files.contains("feed.xml"));
  EXPECT_EQ(files.at("sitemap.xml").find("1.2-y"), std::string::npos);
}

TEST_F(WebFiles, LeadOnFromFormerAddresses) {
  site_.data.manifest = {{"site.css", "a.css"}, {"moved.js", "m.js"}, {"favicon.svg", "f.svg"}};
  KeptFiles files;
  write_moved_pages(site_.data, templates_, files);
  ASSERT_EQ(files.texts.size(), 1U);
  const std::string& page = files.texts.at("1-a/1.2-old.html");
  EXPECT_NE(page.find(R"(content="0; url=../1-a/1.2-y.html")"), page.npos) << page;
  EXPECT_NE(page.find(R"(rel="canonical" href="https://example.org/c/1-a/1.2-y.html")"), page.npos);
  EXPECT_NE(page.find(R"(<a href="../1-a/1.2-y.html">1.2 Two</a>)"), page.npos);
  site_.course.lessons[1].front.draft = true;
  KeptFiles none;
  write_moved_pages(site_.data, templates_, none);
  EXPECT_TRUE(none.texts.empty());
}

}  // namespace
}  // namespace mjcourse
