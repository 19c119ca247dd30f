// Changes JSON as JSON, so that a fuzzer gets past the parser: what is replaced, left out, copied
// or misspelt is a value or a key. One time in three the bytes are changed, as libFuzzer does it.
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using json = nlohmann::ordered_json;

class JsonMutator {
 public:
  explicit JsonMutator(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

  void mutate(json& root) {
    std::vector<json*> all;
    collect(root, all);
    json& at = *all[below(all.size())];
    const json other = *all[below(all.size())];
    switch (below(5)) {
      case 0:
        at = value();
        break;
      case 1:
        at = other;
        break;
      case 2:
        leave_out(at);
        break;
      case 3:
        add(at, other);
        break;
      default:
        change_bytes(at);
    }
  }

 private:
  static void collect(json& value, std::vector<json*>& all) {
    all.push_back(&value);
    if (!value.is_structured()) return;
    for (json& part : value) collect(part, all);
  }

  json value() {
    static const std::vector<json> values{nullptr,
                                          true,
                                          false,
                                          0,
                                          -1,
                                          1,
                                          0.5,
                                          1e300,
                                          "",
                                          "x",
                                          "<mujoco/>",
                                          "1 + 1",
                                          "$x$",
                                          "$$",
                                          "[[t]]",
                                          "a\nb",
                                          "ü",
                                          "# h",
                                          "1%",
                                          json::array(),
                                          "```\n",
                                          "{m} nq",
                                          "[l](",
                                          "|",
                                          "\\",
                                          2e9,
                                          1e-300,
                                          "100%",
                                          json::array({1, 2, 3}),
                                          json::array({"a", "b"}),
                                          json::object()};
    return values[below(values.size())];
  }

  void leave_out(json& at) {
    if (at.is_structured() && !at.empty()) at.erase(std::next(at.begin(), index(at)));
  }

  void add(json& at, const json& other) {
    if (at.is_array()) at.push_back(other);
    if (at.is_object()) at[at.empty() ? "x" : std::next(at.begin(), index(at)).key() + "s"] = other;
  }

  std::ptrdiff_t index(const json& at) { return static_cast<std::ptrdiff_t>(below(at.size())); }

  static void change_bytes(json& at) {
    if (!at.is_string()) return;
    std::string text = at.get<std::string>();
    const std::size_t size = text.size();
    text.resize(size + 16);
    text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), size, text.size()));
    at = text;
  }

  std::mt19937 random_;
};

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  JsonMutator mutator(seed);
  const std::string input(reinterpret_cast<const char*>(data), size);
  const std::size_t line = input.find('\n');
  json tree = line == input.npos || mutator.below(3) == 0
                  ? json(json::value_t::discarded)
                  : json::parse(input.substr(line + 1), nullptr, false);
  if (tree.is_discarded()) return LLVMFuzzerMutate(data, size, most);
  for (std::size_t i = 0; i <= mutator.below(3); ++i) mutator.mutate(tree);
  const std::string text =
      input.substr(0, line + 1) + tree.dump(mutator.below(2) == 0 ? -1 : 1, ' ',
                                            mutator.below(2) == 0, json::error_handler_t::replace);
  if (text.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}
