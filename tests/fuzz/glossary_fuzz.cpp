// A glossary of any bytes.
#include "diagnostic_check.h"
#include "fuzz.h"
#include "lesson/read_glossary.h"
#include "lesson_check.h"
#include "require.h"

namespace mjcourse {
namespace {

void check_glossary(const std::string& bytes) {
  Diagnostics diagnostics;
  const std::optional<Glossary> glossary = read_glossary(bytes, diagnostics);
  check_diagnostics(diagnostics, {{kGlossaryPath, SourceText(kGlossaryPath, bytes)}});
  require(glossary || !diagnostics.empty(), "a glossary that cannot be read is a mistake");
  if (!glossary) return;
  check_lesson(glossary->page);
  for (const Glossary::Term& term : glossary->terms) {
    const Glossary::Term* found = glossary->find(term.key);
    require(found != nullptr && found->key == term.key, "a term is found by its key: " + term.key);
    require(!term.id.empty() && term.definition, "a term has an id and a definition");
  }
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mjcourse::check_glossary(mjcourse::text_of_input(data, size));
  return 0;
}
