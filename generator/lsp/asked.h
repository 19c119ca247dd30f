// Asked: what an editor asks about: a place in a text, and all that is known around it.
// Tested by tests/lsp/sessions.mjs.
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "lesson/json/plot_grammar.h"
#include "lsp/model_names.h"
#include "lsp/open_documents.h"
#include "session/snapshot.h"

namespace mjcourse {

struct Asked {
  const OpenDocuments& documents;
  Units units;
  SnapshotPtr snapshot;  // the newest; not null
  ModelNames& models;
  const PlotGrammar& plots;
  std::shared_ptr<const SourceText> text;  // as it is in the editor; not null
  std::size_t offset = 0;

  const Course& course() const { return snapshot->course; }
  // The text, read as the lesson that it is; nothing where it is none.
  std::optional<Lesson> lesson() const;
  bool is_in(Span span) const { return span.begin <= offset && offset <= span.end; }
  // The text before the place, from the beginning of its line on.
  std::string_view line_before() const;
};

}  // namespace mjcourse
