#include "evaluate/api_reference.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "base/nearest.h"
#include "physics/mujoco_api.h"

namespace mjcourse {
namespace {

constexpr std::string_view kScheme = "api:";

std::string in_words(const ApiName& found) {
  switch (found.kind) {
    case ApiName::Kind::function:
      return "function";
    case ApiName::Kind::structure:
      return "structure";
    case ApiName::Kind::field:
      return "field of " + found.owner;
    case ApiName::Kind::enumeration:
      return "enumeration";
    case ApiName::Kind::constant:
      return "constant of " + found.owner;
    case ApiName::Kind::type:
      return "type";
    case ApiName::Kind::macro:
      return "macro";
    case ApiName::Kind::variable:
      break;
  }
  return "variable";
}

// MuJoCo's documentation has a heading for each function, structure and enumeration. Its pages of
// other versions are cut otherwise.
std::string documentation(const std::string& name, const ApiName& found) {
  const bool headed = found.kind == ApiName::Kind::function ||
                      found.kind == ApiName::Kind::structure ||
                      found.kind == ApiName::Kind::enumeration;
  if ((!headed && found.owner.empty()) || std::string(mj_versionString()) != "2.2.2") return "";
  std::string anchor;
  for (const char c : headed ? name : found.owner) {
    anchor += c == '_' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return "https://mujoco.readthedocs.io/en/2.2.2/APIreference.html#" + anchor;
}

// What `name` may have meant: the field of a structure that it leaves out, or the nearest name.
std::string cure_for(const std::string& name, const MujocoApi& api) {
  const std::string field = "." + name.substr(name.rfind('.') + 1);
  std::vector<std::string> names;
  for (const auto& [known, entry] : api) {
    if (known.ends_with(field)) return "did you mean `" + known + "`?";
    names.push_back(known);
  }
  const std::string meant = nearest(name, names);
  if (!meant.empty()) return "did you mean `" + meant + "`?";
  return "write it as MuJoCo's headers do: `mj_step`, `mjModel.nq`, `mjtJoint`, `mjJNT_FREE`";
}

class Reference {
 public:
  Reference(const Course& course, const MujocoHeaders& headers, Diagnostics& diagnostics)
      : course_(course), headers_(headers), diagnostics_(diagnostics) {}

  std::vector<ApiEntry> run() {
    for (const Lesson* page : course_.pages()) {
      for (const Link& link : page->links) {
        if (link.target.text.starts_with(kScheme)) look_up(*page, link.target);
      }
    }
    std::vector<ApiEntry> entries;
    for (const auto& [name, entry] : entries_) entries.push_back(entry);
    return entries;
  }

 private:
  void look_up(const Lesson& page, const LocatedText& target) {
    const tl::expected<MujocoApi, std::string>& api = headers_();
    const LocatedText name = target.part(kScheme.size(), target.text.size());
    const auto error = [&](const std::string& id, const std::string& message,
                           const std::string& cure) {
      diagnostics_.push_back(error_at(place_of(*page.source, name.span()), id, message, cure));
    };
    if (!api) {
      return error("E-api-headers", "MuJoCo's headers cannot be read: " + api.error(),
                   "name their folder in the environment's MJCOURSE_HEADERS");
    }
    const auto found = api->find(name.text);
    if (found == api->end()) {
      return error("E-api-unknown", "MuJoCo has no `" + name.text + "`", cure_for(name.text, *api));
    }
    if (page.front.draft) return;
    const ApiName& entry = found->second;
    entries_[name.text] = {name.text,
                           in_words(entry),
                           entry.declaration,
                           entry.comment,
                           entry.header,
                           entry.section,
                           documentation(name.text, entry)};
  }

  const Course& course_;
  const MujocoHeaders& headers_;
  Diagnostics& diagnostics_;
  std::map<std::string, ApiEntry> entries_;
};

}  // namespace

std::vector<ApiEntry> evaluate_api(const Course& course, const MujocoHeaders& headers,
                                   Diagnostics& diagnostics) {
  return Reference(course, headers, diagnostics).run();
}

}  // namespace mjcourse
