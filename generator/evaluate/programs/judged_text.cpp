#include "evaluate/programs/judged_text.h"

#include <cstdio>
#include <random>

#include "reported_checks.h"

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

JudgeKey JudgeKey::random() {
  return {"judge_" + hexadecimal(random_number()), random_number(),
          std::to_string(random_number() % 1'000'000'000 + 1), false};
}

std::string reporting_checks(const JudgeKey& key) {
  return "#define MJCOURSE_JUDGE " + key.name + "\n#define MJCOURSE_MARK 0x" +
         hexadecimal(key.mark) + "u\n#line 1 \"reported_checks.hpp\"\n" +
         std::string(kReportedChecks) + "#undef MJCOURSE_MARK\n#undef MJCOURSE_JUDGE\n";
}

std::string tell_answers(const JudgeKey& key) {
  return checks_as(key, "...", "__VA_ARGS__");
}

std::string tell_findings(const JudgeKey& key) {
  return checks_as(key, "value, expected, tolerance, ...", "value, __VA_ARGS__");
}

}  // namespace mjcourse
