// Lessons of one lab on the ball (evaluation_of.h), and their mistakes in a line each.
#pragma once

#include <string>

#include "evaluate/evaluation_of.h"

namespace mjcourse {

// `members` begin line 6, after the title and the model. Its poster is soon drawn.
inline std::string lab_text(const std::string& members, const std::string& model = "ball") {
  return "```lab simlab\n{\"title\": \"T\", \"alt\": \"A.\", \"height\": 20, \"model\": \"" +
         model + "\",\n" + members + "}\n```\n";
}

// Each mistake of such a lab: id, what it underlines, message, cure.
inline std::string rehearsed_mistakes(const std::string& members,
                                      const std::map<std::string, std::string>& files = {},
                                      const std::string& model = "ball") {
  const EvaluationOf evaluation(lab_text(members, model), files);
  std::string text;
  for (const Diagnostic& d : evaluation.diagnostics()) {
    const auto column = static_cast<std::size_t>(d.place.column - 1);
    text += d.id + " <" + d.place.excerpt.substr(column, static_cast<std::size_t>(d.place.width)) +
            "> " + d.message + (d.cure.empty() ? "" : " | " + d.cure) + "\n";
  }
  return text;
}

}  // namespace mjcourse
