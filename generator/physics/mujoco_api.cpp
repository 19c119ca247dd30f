#include "physics/mujoco_api.h"

#include <re2/re2.h>

#include <cctype>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "base/running_text.h"
#include "base/text_lines.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

// A line's code, and what its `//` comment says.
struct Line {
  std::string code, comment;
  bool has_comment = false;
};

Line split(std::string_view line) {
  const std::size_t slashes = line.find("//");
  if (slashes == line.npos) return {std::string(trimmed(line)), "", false};
  return {std::string(trimmed(line.substr(0, slashes))),
          std::string(trimmed(line.substr(slashes + 2))), true};
}

// "------- Main simulation -------" → "Main simulation"; "" for other comments.
std::string section_in(const std::string& comment) {
  static const RE2 ruled(R"(-{3,}\s*(.*?)\s*-*)");
  std::string section;
  RE2::FullMatch(comment, ruled, &section);
  return section;
}

bool is_blank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

// The name that a declaration gives: "mjtNum gravity[3];" → "gravity"; "" where it gives none. Some
// hundred lines are read by hand: regular expressions take milliseconds.
std::string declared_name(std::string_view declaration) {
  if (!declaration.ends_with(';')) return "";
  declaration = trimmed(declaration.substr(0, declaration.size() - 1));
  while (declaration.ends_with(']')) {
    declaration = trimmed(declaration.substr(0, declaration.rfind('[')));
  }
  std::size_t begin = declaration.size();
  while (begin > 0 && is_word_character(declaration[begin - 1])) --begin;
  const bool behind_a_type =
      begin > 0 && (is_blank(declaration[begin - 1]) || declaration[begin - 1] == '*');
  return behind_a_type ? std::string(declaration.substr(begin)) : "";
}

class HeaderReader {
 public:
  HeaderReader(std::string header, MujocoApi& api) : header_(std::move(header)), api_(api) {}

  void run(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.ends_with('\r')) line.pop_back();
      read(line);
    }
  }

 private:
  void read(const std::string& raw) {
    const Line line = split(raw);
    if (!owner_.empty()) return read_member(raw, line);
    if (!statement_.empty()) return go_on(raw, line);
    if (line.code.empty()) return read_comment(line);
    if (line.code.starts_with('#')) return read_macro(line);
    static const RE2 structure(R"(struct (mj\w+?)_ \{)");
    static const RE2 enumeration(R"(typedef enum (mj\w+?)_ \{)");
    std::string name;
    if (RE2::FullMatch(line.code, structure, &name)) {
      open(name, ApiName::Kind::structure, raw, line);
    } else if (RE2::FullMatch(line.code, enumeration, &name)) {
      open(name, ApiName::Kind::enumeration, raw, line);
    } else if (line.code.starts_with("MJAPI ") || line.code.starts_with("typedef ")) {
      go_on(raw, line);
    } else {
      above_.clear();
    }
  }

  // Lines of comments above a declaration belong to it, until a blank line comes.
  void read_comment(const Line& line) {
    if (!line.has_comment) return above_.clear();
    const std::string section = section_in(line.comment);
    if (!section.empty()) section_ = section;
    if (section.empty()) above_ += (above_.empty() ? "" : " ") + line.comment;
  }

  void read_macro(const Line& line) {
    static const RE2 define(R"(#define\s+(mj\w+)(?:\([^)]*\))?(?:\s+.*)?)");
    if (std::string name; RE2::FullMatch(line.code, define, &name)) {
      add(name, {ApiName::Kind::macro, with_single_blanks(line.code),
                 line.has_comment ? line.comment : above_, header_, section_, ""});
    }
    above_.clear();
  }

  // A statement at the header's top level, which may take several lines.
  void go_on(const std::string& raw, const Line& line) {
    statement_ += (statement_.empty() ? "" : "\n") + std::string(trimmed_end(raw, line));
    behind_ = line.has_comment ? line.comment : behind_;
    if (!line.code.ends_with(';')) return;
    finish_statement();
    statement_.clear();
    behind_.clear();
    above_.clear();
  }

  static std::string trimmed_end(const std::string& raw, const Line& line) {
    const std::string code = raw.substr(0, line.has_comment ? raw.find("//") : raw.npos);
    const std::size_t end = code.find_last_not_of(" \t");
    return end == code.npos ? "" : code.substr(0, end + 1);
  }

  void finish_statement() {
    static const RE2 api(R"(^MJAPI (extern )?)");
    static const RE2 function(R"((?s)[^(]*?(mj\w+)\(.*)");
    static const RE2 pointer(R"((?s)[^(]*\(\*\s*(mj\w+)\).*)");
    const bool exported = statement_.starts_with("MJAPI ");
    std::string plain = statement_;
    RE2::Replace(&plain, api, R"(\1)");
    const std::string declaration(trimmed(plain));
    ApiName found{ApiName::Kind::type,
                  declaration,
                  behind_.empty() ? above_ : behind_,
                  header_,
                  section_,
                  ""};
    std::string name;
    if (RE2::FullMatch(declaration, pointer, &name)) {
      if (exported) found.kind = ApiName::Kind::variable;
      return add(name, found);
    }
    if (exported && !declaration.starts_with("extern ") &&
        RE2::FullMatch(declaration, function, &name)) {
      found.kind = ApiName::Kind::function;
      return add(name, found);
    }
    if (exported) found.kind = ApiName::Kind::variable;
    const bool of_structure = declaration.starts_with("typedef struct ");
    if (!of_structure) add(declared_name(declaration), found);
  }

  void open(const std::string& name, ApiName::Kind kind, const std::string& raw, const Line& line) {
    owner_ = name;
    owner_kind_ = kind;
    body_ = raw;
    owner_comment_ = line.has_comment ? line.comment : above_;
    above_.clear();
    inner_.clear();
  }

  void read_member(const std::string& raw, const Line& line) {
    body_ += "\n" + raw;
    if (line.code.starts_with('}')) {
      if (!inner_.empty()) return close_inner(line.code);
      return close();
    }
    if (line.code == "struct {" || line.code == "union {") {
      inner_.emplace_back();
      return;
    }
    if (line.code.empty()) return;
    if (owner_kind_ == ApiName::Kind::enumeration) return add_constant(line);
    const std::string name = declared_name(line.code);
    if (name.empty()) return;
    const ApiName field{ApiName::Kind::field,
                        with_single_blanks(line.code),
                        with_single_blanks(line.comment),
                        header_,
                        section_,
                        owner_};
    if (inner_.empty()) {
      add(owner_ + "." + name, field);
    } else {
      inner_.back().emplace_back(name, field);
    }
  }

  // The name of a struct inside of a struct stands behind it, if it has one: "} global;".
  void close_inner(const std::string& code) {
    const std::string name_behind = declared_name(code);
    const std::string group = name_behind.empty() ? "" : name_behind + ".";
    const auto members = std::move(inner_.back());
    inner_.pop_back();
    for (const auto& [name, field] : members) {
      if (inner_.empty()) {
        add(owner_ + "." + group + name, field);
      } else {
        inner_.back().emplace_back(group + name, field);
      }
    }
  }

  void add_constant(const Line& line) {
    static const RE2 constant(R"((mj\w+)\s*(?:=[^,]*)?,?)");
    std::string name;
    if (!RE2::FullMatch(line.code, constant, &name)) return;
    std::string code = with_single_blanks(line.code);
    if (code.ends_with(',')) code.pop_back();
    add(name, {ApiName::Kind::constant, code, with_single_blanks(line.comment), header_, section_,
               owner_});
  }

  void close() {
    add(owner_, {owner_kind_, body_, owner_comment_, header_, section_, ""});
    owner_.clear();
    above_.clear();
  }

  // The first wins: of two branches of an #ifdef, that which is taken comes first.
  void add(const std::string& name, const ApiName& found) {
    if (name.starts_with("mj")) api_.emplace(name, found);
  }

  std::string header_;
  MujocoApi& api_;
  std::string section_;
  std::string above_;                         // comments right above this line
  std::string statement_, behind_;            // being read, and the comment behind it
  std::string owner_, body_, owner_comment_;  // the struct or enum being read
  ApiName::Kind owner_kind_ = ApiName::Kind::structure;
  std::vector<std::vector<std::pair<std::string, ApiName>>> inner_;  // structs inside of it
};

}  // namespace

void read_api_header(const std::string& header, const std::string& text, MujocoApi& api) {
  HeaderReader(header, api).run(text);
}

tl::expected<MujocoApi, std::string> read_mujoco_api(const Files& headers) {
  MujocoApi api;
  const auto main = headers.read("mujoco/mujoco.h");
  if (!main) return tl::unexpected(main.error());
  static const RE2 include(R"(#include <mujoco/(\w+\.h)>)");
  std::vector<std::string> names{"mujoco.h"};
  re2::StringPiece rest(*main);
  for (std::string name; RE2::FindAndConsume(&rest, include, &name);) names.push_back(name);
  for (const std::string& name : names) {
    const auto text = headers.read("mujoco/" + name);
    if (!text) return tl::unexpected(text.error());
    read_api_header(name, *text, api);
  }
  return api;
}

std::string mujoco_headers_folder() {
  const char* named = std::getenv("MJCOURSE_HEADERS");
  return named != nullptr ? named : MJCOURSE_MUJOCO_HEADERS;
}

const tl::expected<MujocoApi, std::string>& installed_mujoco_api() {
  static const tl::expected<MujocoApi, std::string> read =
      read_mujoco_api(DiskFiles(mujoco_headers_folder()));
  return read;
}

}  // namespace mjcourse
