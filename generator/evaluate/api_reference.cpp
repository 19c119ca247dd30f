#include "evaluate/api_reference.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "base/nearest.h"
#include "base/parallel.h"
#include "evaluate/code_names.h"
#include "lesson/blocks/block_scripts.h"
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

struct Code {
  std::string_view text;
  Span place;  // in its lesson
};

// What a reader sees of code that was found to work: a program, or a block's scripts.
std::vector<Code> code_of(const Block& block, const Result& result) {
  std::vector<Code> found;
  if (const auto* example = std::get_if<Example>(&block); example != nullptr && example->compiles) {
    found.push_back({std::get<ExampleResult>(result).code, example->span});
  }
  if (const auto* snippet = std::get_if<Snippet>(&block)) {
    found.push_back({snippet->shown, snippet->span});
  }
  for (const BlockScript& script : scripts_of(block)) {
    found.push_back({script.text->text, script.text->span()});
  }
  return found;
}

// A name that the code of a page uses, and where.
struct FoundUse {
  std::string name;
  CodeUse use;
};

class Reference {
 public:
  Reference(const Course& course, const ResultsOf& results, const MujocoHeaders& headers,
            Diagnostics& diagnostics)
      : pages_(course.pages()), results_(results), headers_(headers), diagnostics_(diagnostics) {}

  std::vector<ApiEntry> run(std::size_t threads) {
    std::vector<std::vector<FoundUse>> in_code(pages_.size());
    for_each_index(pages_.size(), threads, [&](std::size_t i, std::size_t) {
      if (!pages_[i]->front.draft) in_code[i] = uses_in_code(i);
    });
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      for (const Link& link : pages_[i]->links) {
        if (link.target.text.starts_with(kScheme)) look_up(*pages_[i], link.target);
      }
      for (auto& [name, use] : in_code[i]) {
        entry_of(name, *headers_()).uses_in_code.push_back(std::move(use));
      }
    }
    std::vector<ApiEntry> entries;
    for (auto& [name, entry] : entries_) entries.push_back(std::move(entry));
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
    if (!api->contains(name.text)) {
      return error("E-api-unknown", "MuJoCo has no `" + name.text + "`", cure_for(name.text, *api));
    }
    if (!page.front.draft) entry_of(name.text, *api);
  }

  std::vector<FoundUse> uses_in_code(std::size_t page) const {
    std::vector<FoundUse> found;
    for (const auto& [block, result] : results_(*pages_[page]).of_block) {
      const Block& shown = pages_[page]->blocks[block];
      const bool has_lines = std::holds_alternative<Example>(shown);
      for (const auto& [text, place] : code_of(shown, result)) {
        if (!headers_()) return {};
        for (auto& [name, lines] : names_in_code(text, *headers_())) {
          found.push_back(
              {name, {page, block, place, has_lines ? std::move(lines) : std::set<int>()}});
        }
      }
    }
    return found;
  }

  ApiEntry& entry_of(const std::string& name, const MujocoApi& api) {
    ApiEntry& entry = entries_[name];
    if (entry.name.empty()) {
      const ApiName& found = api.at(name);
      entry = {name,         in_words(found), found.declaration,         found.comment,
               found.header, found.section,   documentation(name, found)};
    }
    return entry;
  }

  const std::vector<const Lesson*> pages_;
  const ResultsOf& results_;
  const MujocoHeaders& headers_;
  Diagnostics& diagnostics_;
  std::map<std::string, ApiEntry> entries_;
};

}  // namespace

std::vector<ApiEntry> evaluate_api(const Course& course, const ResultsOf& results,
                                   const MujocoHeaders& headers, std::size_t threads,
                                   Diagnostics& diagnostics) {
  return Reference(course, results, headers, diagnostics).run(threads);
}

}  // namespace mjcourse
