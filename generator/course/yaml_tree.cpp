#include "course/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <sstream>

namespace mjcourse {
namespace {

class AliasFinder : public YAML::EventHandler {
 public:
  bool found() const { return found_; }

  void OnAlias(const YAML::Mark&, YAML::anchor_t) override { found_ = true; }
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

 private:
  bool found_ = false;
};

}  // namespace

bool same_tree(const YAML::Node& a, const YAML::Node& b) {
  if (a.Type() != b.Type() || a.size() != b.size()) return false;
  if (a.IsScalar()) return a.Scalar() == b.Scalar();
  return std::equal(a.begin(), a.end(), b.begin(), [&](const auto& one, const auto& other) {
    return a.IsSequence()
               ? same_tree(one, other)
               : same_tree(one.first, other.first) && same_tree(one.second, other.second);
  });
}

bool has_aliases(const std::string& yaml) {
  AliasFinder finder;
  std::istringstream text(yaml);
  YAML::Parser(text).HandleNextDocument(finder);
  return finder.found();
}

}  // namespace mjcourse
