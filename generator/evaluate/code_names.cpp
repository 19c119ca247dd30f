#include "evaluate/code_names.h"

#include <cctype>
#include <utility>
#include <vector>

#include "base/utf8.h"

namespace mjcourse {
namespace {

struct Token {
  std::string_view text;  // a word, "->", or one character
  int line = 0;
};

class Tokens {
 public:
  explicit Tokens(std::string_view code) : code_(code) {}

  std::vector<Token> run() {
    while (at_ < code_.size()) {
      const std::string_view rest = code_.substr(at_);
      if (std::isspace(static_cast<unsigned char>(rest[0])) != 0) {
        pass(1);
      } else if (rest.starts_with("//")) {
        pass(rest.find('\n'));
      } else if (rest.starts_with("/*")) {
        pass_behind("*/", 2);
      } else if (rest.starts_with("R\"")) {
        pass_behind(")" + std::string(rest.substr(2, rest.find('(') - 2)) + "\"", 2);
      } else if (rest[0] == '"' || rest[0] == '\'' || rest[0] == '`') {
        pass_string(rest);
      } else {
        take(rest);
      }
    }
    return std::move(tokens_);
  }

 private:
  void take(std::string_view rest) {
    std::size_t size = 1;
    if (is_word_character(rest[0])) {
      while (size < rest.size() && is_word_character(rest[size])) ++size;
      // 1'000'000 is no string.
      while (is_digit(rest[0]) && size + 1 < rest.size() &&
             (is_word_character(rest[size]) ||
              (rest[size] == '\'' && is_word_character(rest[size + 1])))) {
        ++size;
      }
    } else if (rest.starts_with("->")) {
      size = 2;
    }
    tokens_.push_back({rest.substr(0, size), line_});
    at_ += size;
  }

  void pass_string(std::string_view rest) {
    std::size_t end = 1;
    while (end < rest.size() && rest[end] != rest[0]) end += rest[end] == '\\' ? 2 : 1;
    pass(end + 1);
  }

  void pass_behind(const std::string& mark, std::size_t from) {
    const std::size_t end = code_.find(mark, at_ + from);
    pass(end == code_.npos ? end : end + mark.size() - at_);
  }

  void pass(std::size_t count) {
    for (const std::size_t end = count < code_.size() - at_ ? at_ + count : code_.size(); at_ < end;
         ++at_) {
      line_ += code_[at_] == '\n' ? 1 : 0;
    }
  }

  std::string_view code_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

class Finder {
 public:
  Finder(std::vector<Token> tokens, const MujocoApi& api) : tokens_(std::move(tokens)), api_(api) {}

  CodeNames run() {
    look(false);
    return std::move(names_);
  }

 private:
  std::string_view text(std::size_t index) const {
    return index < tokens_.size() ? tokens_[index].text : std::string_view();
  }

  // At all that follows, or at what stands before the next bracket that closes.
  void look(bool in_brackets) {
    while (at_ < tokens_.size()) {
      const std::string word(text(at_));
      if (is_structure(word) || is_owner(word)) declare(is_owner(word) ? "mj" + word : word);
      if (word.starts_with("mj") && api_.contains(word)) names_[word].insert(tokens_[at_].line);
      ++at_;
      if (in_brackets && word == "]") return;
      if (text(at_) != "." && text(at_) != "->" && text(at_) != "[") continue;
      const auto object = objects_.find(word);
      follow(object != objects_.end() ? object->second : "");
    }
  }

  bool is_structure(const std::string& word) const {
    if (!word.starts_with("mj")) return false;  // spares a search for each word of a program
    const auto found = api_.find(word);
    return found != api_.end() && found->second.kind == ApiName::Kind::structure;
  }
  // Of the helper header's: an object of its own, which stands for MuJoCo's.
  static bool is_owner(const std::string& word) { return word == "Model" || word == "Data"; }

  // `const mjContact& contact`: the word behind the type, if one stands there.
  void declare(const std::string& structure) {
    std::size_t next = at_ + 1;
    while (text(next) == "*" || text(next) == "&" || text(next) == "const") ++next;
    if (!text(next).empty() && is_word_character(text(next)[0])) {
      objects_[std::string(text(next))] = structure;
    }
  }

  // The chain that goes on at `at_`, behind an object that is a `structure`, or something unknown.
  void follow(std::string structure) {
    for (;;) {
      if (text(at_) == "[") {
        ++at_;
        look(true);
      }
      const bool arrow = text(at_) == "->";
      if ((!arrow && text(at_) != ".") || text(at_ + 1).empty()) return;
      const std::string field(text(at_ + 1));
      if (structure.empty() && arrow) structure = only_one_with(field);
      structure = take(structure, field, tokens_[at_ + 1].line);
      const auto object = objects_.find(field);
      if (structure.empty() && object != objects_.end()) structure = object->second;
      at_ += 2;
    }
  }

  // Notes that `field` is used, and gives what structure it is, or a group of fields,
  // "mjVisual.map"; nothing for numbers, and where there is no such field.
  std::string take(const std::string& structure, const std::string& field, int line) {
    const std::string name = structure + "." + field;
    const auto found = api_.lower_bound(name);
    if (structure.empty() || found == api_.end()) return "";
    if (found->first.starts_with(name + ".")) return found->first.substr(0, name.size());
    if (found->first != name) return "";
    names_[name].insert(line);
    std::string type = found->second.declaration;
    type = type.substr(0, type.find_first_of(" *"));
    return is_structure(type) ? type : "";
  }

  std::string only_one_with(const std::string& field) const {
    const bool model = api_.contains("mjModel." + field), data = api_.contains("mjData." + field);
    if (model == data) return "";
    return model ? "mjModel" : "mjData";
  }

  std::vector<Token> tokens_;
  const MujocoApi& api_;
  std::size_t at_ = 0;
  std::map<std::string, std::string> objects_{
      {"model", "mjModel"}, {"m", "mjModel"}, {"data", "mjData"}, {"d", "mjData"}};
  CodeNames names_;
};

}  // namespace

CodeNames names_in_code(std::string_view code, const MujocoApi& api) {
  return Finder(Tokens(code).run(), api).run();
}

}  // namespace mjcourse
