#include "evaluate/answers/proof_text.h"

#include <cmath>
#include <sstream>

namespace mjcourse {
namespace {

std::string with_digits(double value, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

std::string joints_text(const Proof& proof) {
  std::vector<std::string> kinds;
  int joints = 0;
  for (const char* kind : {"hinge", "slide", "ball", "free"}) {
    const int count = joint_count(proof, kind);
    if (count == 0) continue;
    joints += count;
    kinds.push_back(std::to_string(count) + " " + kind);
  }
  if (joints == 0) return "no joints";
  return listed(kinds) + (joints == 1 ? " joint" : " joints");
}

}  // namespace

std::string number_text(double value) {
  const bool whole = std::trunc(value) == value && std::abs(value) < 1e15;
  return with_digits(value, whole ? 15 : 10);
}

std::string number_text(double value, double other) {
  std::string text = number_text(value);
  if (text != number_text(other)) return text;
  int digits = 11;
  while (digits < 17 && with_digits(value, digits) == with_digits(other, digits)) ++digits;
  return with_digits(value, digits);
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

int joint_count(const Proof& proof, const std::string& kind) {
  const auto found = proof.joints.find(kind);
  return found == proof.joints.end() ? 0 : found->second;
}

std::string built_text(const Proof& proof) {
  if (!proof.example.text.empty()) return proof.example.text;
  if (!proof.model.text.empty()) return proof.model.text;
  return proof.mjcf.text.empty() ? joints_text(proof) : "the model in the question";
}

std::string built_model(const Proof& proof) {
  if (!proof.example.text.empty()) return proof.example.text + ".cpp";
  if (!proof.model.text.empty()) return proof.model.text + ".xml";
  return proof.mjcf.text.empty() ? "a model with " + joints_text(proof) : built_text(proof);
}

}  // namespace mjcourse
