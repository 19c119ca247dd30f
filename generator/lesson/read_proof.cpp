#include "lesson/read_proof.h"

#include <cmath>
#include <string>

#include "lesson/json_object.h"

namespace mjcourse {
namespace {

constexpr double kMostSeconds = 100;  // simulated for one proof

std::map<std::string, int> read_joints(const JsonValue* value, Reading& reading) {
  std::map<std::string, int> joints;
  if (value == nullptr) return joints;
  JsonObject object(*value, "set of joints", reading);
  for (const char* kind : {"free", "ball", "slide", "hinge"}) {
    const double count = object.number(kind, 0);
    if (count < 0 || count > 1000 || count != std::floor(count)) {
      reading.error("E-json-range", object.find(kind)->span,
                    "\"" + std::string(kind) + "\" counts joints: a whole number from 0 to 1000");
    } else if (count > 0) {
      joints[kind] = static_cast<int>(count);
    }
  }
  object.finish();
  return joints;
}

}  // namespace

std::optional<Proof> read_proof(const JsonValue& value, const Question& question,
                                Reading& reading) {
  JsonObject object(value, "proof", reading);
  Proof proof;
  proof.span = value.span;
  const bool by_joints = object.has("joints");
  proof.joints = read_joints(object.find("joints"), reading);
  proof.model = object.string("model");
  proof.mjcf = object.script("mjcf");
  proof.because = object.string("because");
  proof.run = object.script("run");
  proof.seconds = object.number("seconds", 0);
  if (proof.seconds < 0 || proof.seconds > kMostSeconds) {
    reading.error("E-json-range", object.find("seconds")->span,
                  "\"seconds\" is simulated time: from 0 to 100");
    proof.seconds = 0;
  }
  proof.value = object.script("value");
  proof.equals = object.optional_number("equals");
  for (const JsonValue& option : object.list("options")) {
    if (option.kind != JsonValue::Kind::string) report_kind("options", option, "a string", reading);
    proof.options.push_back(option.string);
  }
  object.not_yet("example");
  object.finish();

  if (value.kind != JsonValue::Kind::object) return std::nullopt;
  const Span open{value.span.begin, value.span.begin + 1};
  const int sources = (by_joints ? 1 : 0) + (proof.model.text.empty() ? 0 : 1) +
                      (proof.mjcf.text.empty() ? 0 : 1) + (proof.because.text.empty() ? 0 : 1);
  const bool computes = proof.because.text.empty();
  std::string wrong, cure;
  if (sources != 1) {
    wrong = "a proof needs exactly one of \"joints\", \"model\", \"mjcf\" and \"because\"";
  } else if (computes && proof.value.text.empty() == proof.options.empty()) {
    wrong = "a proof needs a \"value\", or \"options\" with one expression for each option";
  } else if (!proof.options.empty() && proof.options.size() != question.options.size()) {
    wrong = "the proof has " + std::to_string(proof.options.size()) + " expressions for " +
            std::to_string(question.options.size()) + " options";
    cure = "write one expression for each option, in their order";
  } else if (question.kind == Question::Kind::choice && computes && proof.options.empty() &&
             !proof.equals) {
    wrong = "a choice is proved by \"options\", one expression each; a \"value\" needs \"equals\"";
  }
  if (wrong.empty()) return proof;
  reading.error("E-proof-form", open, wrong, cure);
  return std::nullopt;
}

}  // namespace mjcourse
