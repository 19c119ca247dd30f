#include "report/junit.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>

namespace mjcourse {
namespace {

// XML has no place for control characters, U+FFFE and U+FFFF, not even escaped (XML 1.0, production
// 2).
std::string plain(std::string text) {
  const auto is_barred = [](char c) { return c >= 0 && c < ' ' && c != '\n' && c != '\t'; };
  std::replace_if(text.begin(), text.end(), is_barred, '?');
  for (const char* barred : {"\uFFFE", "\uFFFF"}) {
    for (std::size_t at; (at = text.find(barred)) != text.npos;) text.replace(at, 3, "\uFFFD");
  }
  return text;
}

// The report may be printed into the log of a service that takes `::` at a line's beginning, and
// `##[` in a line, for commands. A reader of XML sees the same characters.
std::string without_commands(const std::string& xml) {
  std::string text;
  bool begins = true;
  for (std::size_t at = 0; at < xml.size(); ++at) {
    const std::string_view rest = std::string_view(xml).substr(at);
    const char c = xml[at];
    if ((begins && rest.starts_with("::")) || rest.starts_with("##")) {
      text += c == ':' ? "&#58;" : "&#35;";
    } else {
      text += c;
    }
    const bool blank = c == ' ' || c == '\t' || static_cast<unsigned char>(c) >= 0x80;
    begins = c == '\n' || (begins && blank);
  }
  return text;
}

std::string rounded(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

class JunitWriter {
 public:
  void open(const char* element, const std::string& name, const std::vector<TestCase>& cases,
            double seconds) {
    const auto count = [&](std::string TestCase::*why) {
      return std::count_if(cases.begin(), cases.end(),
                           [&](const TestCase& one) { return !(one.*why).empty(); });
    };
    xml_.OpenElement(element);
    attribute("name", name);
    attribute("tests", std::to_string(cases.size()));
    attribute("failures", std::to_string(count(&TestCase::failure)));
    attribute("errors", "0");
    attribute("skipped", std::to_string(count(&TestCase::skipped)));
    attribute("time", rounded(seconds));
  }

  void test(const TestSuite& suite, const TestCase& one) {
    xml_.OpenElement("testcase");
    attribute("classname", suite.file);
    attribute("name", one.name);
    attribute("file", suite.file);
    if (one.line > 0) attribute("line", std::to_string(one.line));
    attribute("time", rounded(one.seconds));
    if (!one.skipped.empty()) {
      xml_.OpenElement("skipped");
      attribute("message", one.skipped);
      xml_.CloseElement();
    }
    if (!one.failure.empty()) {
      xml_.OpenElement("failure");
      attribute("type", one.id);
      attribute("message", one.name);
      xml_.PushText(plain(one.failure).c_str());
      xml_.CloseElement();
    }
    xml_.CloseElement();
  }

  void attribute(const char* name, const std::string& value) {
    std::string line = plain(value);
    std::replace(line.begin(), line.end(), '\n', ' ');
    xml_.PushAttribute(name, line.c_str());
  }
  void close() { xml_.CloseElement(); }

  std::string take() const { return xml_.CStr(); }

  JunitWriter() { xml_.PushDeclaration(R"(xml version="1.0" encoding="UTF-8")"); }

 private:
  tinyxml2::XMLPrinter xml_;
};

}  // namespace

std::string junit_xml(const std::vector<TestSuite>& suites, double seconds) {
  std::vector<TestCase> all;
  for (const TestSuite& suite : suites) {
    all.insert(all.end(), suite.cases.begin(), suite.cases.end());
  }
  JunitWriter writer;
  writer.open("testsuites", "mjcourse", all, seconds);
  for (const TestSuite& suite : suites) {
    double taken = 0;
    for (const TestCase& one : suite.cases) taken += one.seconds;
    writer.open("testsuite", suite.name, suite.cases, taken);
    writer.attribute("file", suite.file);
    for (const TestCase& one : suite.cases) writer.test(suite, one);
    writer.close();
  }
  writer.close();
  return without_commands(writer.take());
}

}  // namespace mjcourse
