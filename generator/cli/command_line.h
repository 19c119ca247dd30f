// The options and words of one command, declared once: from that come what is read, what is said of
// a wrong command line, and the command's help.
//
// Declare them, then read. CLI11 2.1.2 takes `--out=` for an option whose value is the next word,
// and "[a, b]" for two words; around that it was no less code than this.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mjcourse {

struct WrongUsage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Perhaps another command has it.
struct UnknownOption : WrongUsage {
  UnknownOption(std::string option, const std::string& message)
      : WrongUsage(message), name(std::move(option)) {}
  std::string name;
};

// What must stand behind an option: "DIR" in the help, "a folder" in a message.
struct ValueKind {
  std::string shown, called;
};
inline const ValueKind kFolder{"DIR", "a folder"}, kFile{"FILE", "a file"};

class CommandLine {
 public:
  explicit CommandLine(std::string command) : command_(std::move(command)) {}

  void flag(std::string name, std::string help, bool& on);
  void path(const std::string& name, const ValueKind& kind, std::string help,
            std::filesystem::path& to);
  // `take` says whether a value is one of that kind; `known` are all of them, where they are few.
  void value(std::string name, ValueKind kind, std::string help,
             std::function<bool(const std::string&)> take, std::vector<std::string> known = {});
  // All that is no option: `form` is "[WHERE...]".
  void words(std::string form, std::string help, std::vector<std::string>& to);

  // False where help is asked for. Throws WrongUsage.
  bool read(const std::vector<std::string>& arguments);

  bool has(const std::string& option) const;
  // "accept [WHERE...]"
  std::string form() const { return command_ + (form_.empty() ? "" : " " + form_); }
  std::string help(const std::string& summary) const;

 private:
  struct Option {
    std::string name;
    ValueKind kind;  // of nothing, where no value may follow
    std::string help;
    std::function<bool(const std::string&)> take;
    std::vector<std::string> known;
  };

  const Option& option_called(const std::string& name) const;
  bool names_a_file(const std::string& argument) const;
  static void take_value(const Option& option, const std::string& value);
  void take_word(const std::string& word) const;

  std::string command_, form_, words_help_;
  std::vector<std::string>* words_ = nullptr;
  std::vector<Option> options_;
};

// `name`, and from column `indent` on what it is for.
std::string help_line(const std::string& name, const std::string& what, std::size_t indent);

}  // namespace mjcourse
