// Reading: what every reader of the lesson language holds in its hand: the file being read and
// the list that its mistakes go to.
#pragma once

#include <string>
#include <utility>

#include "base/source_text.h"
#include "report/diagnostic.h"

namespace mjcourse {

class Reading {
 public:
  Reading(const SourceText& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  const SourceText& source() const { return source_; }

  // Note a mistake at `span` and go on.
  void error(std::string id, Span span, std::string message, std::string cure = "") {
    diagnostics_.push_back(
        error_at(place_of(source_, span), std::move(id), std::move(message), std::move(cure)));
  }

 private:
  const SourceText& source_;
  Diagnostics& diagnostics_;
};

}  // namespace mjcourse
