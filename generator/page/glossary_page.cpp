#include "page/glossary_page.h"

#include <vector>

#include "course/uses.h"
#include "page/html/reader_text.h"
#include "page/html/uses_data.h"
#include "script/collation.h"

namespace mjcourse {

std::string glossary_page(const Course& course, const Evaluation& evaluation,
                          const PageContext& context, const std::string& collation) {
  const Glossary& glossary = *course.glossary;
  const PageWriter writer(course, glossary.page, evaluation.glossary, context);
  nlohmann::json terms = nlohmann::json::array();
  for (const std::size_t at : alphabetical(collation, course.language, glossary.names())) {
    const Glossary::Term& term = glossary.terms[at];
    terms.push_back({{"id", term.id},
                     {"name", writer.children_html(term.heading.get())},
                     {"definition", writer.html(term.definition)},
                     {"uses", uses_data(uses_of_term(course, term.key), evaluation, "")}});
  }
  return render_template(context.templates, "glossary",
                         {{"title", glossary.page.front.title.text},
                          {"summary", writer.inline_html(glossary.page.front.summary)},
                          {"introduction", writer.html(glossary.page.document)},
                          {"terms", std::move(terms)}});
}

std::map<std::string, std::string> plain_definitions(const Course& course,
                                                     const Evaluation& evaluation) {
  std::map<std::string, std::string> definitions;
  if (!course.glossary) return definitions;
  for (const Glossary::Term& term : course.glossary->terms) {
    definitions[term.key] =
        reader_text(term.definition.get(), course.glossary->page, evaluation.glossary);
  }
  return definitions;
}

}  // namespace mjcourse
