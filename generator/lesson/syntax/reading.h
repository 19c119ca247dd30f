// Reading: what every reader of the lesson language holds in its hand: the file being read and
// the list that its mistakes go to.
#pragma once

#include <string>
#include <utility>

#include "base/source_text.h"
#include "report/diagnostic.h"

namespace mjcourse {

inline constexpr int kMostMistakes = 1000;

class Reading {
 public:
  Reading(const SourceText& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  const SourceText& source() const { return source_; }
  // How many there were so far.
  int mistakes() const { return mistakes_; }

  // Note a mistake at `span` and go on. Of a thousand, the rest is not told.
  void error(std::string id, Span span, std::string message, std::string cure = "") {
    note(Severity::error, std::move(id), span, std::move(message), std::move(cure));
  }

  // The same of what may be meant as it stands.
  void warning(std::string id, Span span, std::string message, std::string cure) {
    note(Severity::warning, std::move(id), span, std::move(message), std::move(cure));
  }

 private:
  void note(Severity severity, std::string id, Span span, std::string message, std::string cure) {
    if (++mistakes_ > kMostMistakes) return;
    if (mistakes_ == kMostMistakes) {
      severity = Severity::error;
      id = "E-mistakes";
      message = "this file has a thousand mistakes or more; those from here on are not reported";
      cure = "fix the first ones: others often follow from them";
    }
    diagnostics_.push_back(
        error_at(place_of(source_, span), std::move(id), std::move(message), std::move(cure)));
    diagnostics_.back().severity = severity;
  }

  const SourceText& source_;
  Diagnostics& diagnostics_;
  int mistakes_ = 0;
};

}  // namespace mjcourse
