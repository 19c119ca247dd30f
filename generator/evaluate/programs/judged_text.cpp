#include "evaluate/programs/judged_text.h"

#include <re2/re2.h>

#include <cstdio>
#include <random>

#include "reported_checks.h"
#include "sip_hash_text.h"

namespace mjcourse {
namespace {

std::uint64_t random_number() {
  std::random_device device;
  return (std::uint64_t{device()} << 32) | device();
}

std::string hexadecimal(std::uint64_t number) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return text;
}

// `near` is what the checks of two numbers are given.
std::string checks_as(const JudgeKey& key, const std::string& parameters, const std::string& near) {
  const std::string call = "::" + key.name + "::Call{}, ";
  const auto macro = [&](const std::string& name, const std::string& takes,
                         const std::string& gives) {
    return "#undef " + name + "\n#define " + name + "(" + takes + ") " + name + "(" + call + gives +
           ")\n";
  };
  return macro("expect", "...", "__VA_ARGS__") + macro("expect_near", parameters, near) +
         macro("expect_alike", "...", "__VA_ARGS__");
}

}  // namespace

// The place of the code in its program, of which only the judge knows the name.
std::string place_mark(const JudgeKey& key, int line) {
  return std::to_string(line) + " \"" + key.name + "\"\n";
}

JudgeKey JudgeKey::random() {
  return {"judge_" + hexadecimal(random_number()),
          {random_number(), random_number()},
          std::to_string(random_number() % 999'999'999 + 1),
          false};
}

bool is_seed(const std::string& text) {
  static const RE2 form(R"([1-9]\d{0,8})");
  return RE2::FullMatch(text, form);
}

std::string reporting_checks(const JudgeKey& key) {
  const auto number = [](std::uint64_t n) { return "0x" + hexadecimal(n) + "u"; };
  // It begins with `#pragma once`, which a program does not.
  const std::string_view hash = kSipHash.substr(kSipHash.find("#include"));
  return "#define MJCOURSE_JUDGE " + key.name + "\n#define MJCOURSE_MARK {" +
         number(key.mark.first) + ", " + number(key.mark.second) +
         "}\n#line 1 \"reported_checks.hpp\"\n" + std::string(hash) + std::string(kReportedChecks) +
         "#undef MJCOURSE_MARK\n#undef MJCOURSE_JUDGE\n";
}

std::string end_of_checks(const JudgeKey& key) {
  return "::" + key.name + "::ended";
}

std::string marked_code(const JudgeKey& key, const std::string& code, int line,
                        const std::string& path) {
  return "#line " + place_mark(key, 1) + "#line " + std::to_string(line) + " \"" + path + "\"\n" +
         code + "#line " + place_mark(key, 2);
}

std::optional<std::string> find_marked_code(const JudgeKey& key, const std::string& preprocessed) {
  const std::string begin = "# " + place_mark(key, 1), end = "# " + place_mark(key, 2);
  const std::size_t at = preprocessed.find(begin);
  const std::size_t behind = preprocessed.find(end, at);
  if (at == preprocessed.npos || behind == preprocessed.npos) return std::nullopt;
  return preprocessed.substr(at + begin.size(), behind - at - begin.size());
}

std::string tell_answers(const JudgeKey& key) {
  return checks_as(key, "...", "__VA_ARGS__");
}

std::string tell_findings(const JudgeKey& key) {
  return checks_as(key, "value, expected, tolerance, ...",
                   "::" + key.name + "::like<decltype(expected)>(value), __VA_ARGS__");
}

}  // namespace mjcourse
