#include "evaluate/scenes/plot.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "evaluate/scenes/svg_faults.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr std::size_t kMostValues = 200'000;  // of a table that is drawn

// The member or item of `value` that `step` leads to, and its key where it has one.
struct Step {
  const JsonValue* value = nullptr;
  const LocatedText* key = nullptr;
};
Step take(const JsonValue& value, const json& step) {
  if (step.is_number()) {
    const auto index = step.get<std::size_t>();
    return index < value.items.size() ? Step{&value.items[index]} : Step{};
  }
  for (const JsonMember& member : value.members) {
    if (member.key.text == step.get<std::string>()) return {&member.value, &member.key};
  }
  return {};
}

// Where in the lesson `fault` is: at the last step of its path that the lesson has.
Span place_of_fault(const Plot& plot, const PlotFault& fault) {
  if (fault.path.empty()) return plot.span;
  Step at{&plot.tree};
  for (const json& step : fault.path) {
    const Step next = take(*at.value, step);
    if (next.value == nullptr) break;
    at = next;
  }
  if (fault.key && at.key != nullptr) return at.key->span();
  if (fault.to > 0) return at.value->string.span(fault.from, fault.to);
  return at.value->span;
}

// In a page HTML's rules hold: the text of some elements is HTML's again, and `<!` and `<?` begin
// comments. So the list is shorter than that of a file.
bool is_plain(const PlotDrawing& drawing, const std::string& name) {
  for (const char* barred : {"<!", "<?", "<title", "<desc", "<style", "<svg", "</svg"}) {
    if (drawing.svg.find(barred) != std::string::npos) return false;
  }
  return is_part_of_page(R"(<svg xmlns="http://www.w3.org/2000/svg">)" + drawing.svg + "</svg>",
                         name);
}

json columns_of(const Table& table) {
  json columns = json::array();
  for (const Column& column : table) {
    columns.push_back(json::array({column.name, column.values}));
  }
  return columns;
}

}  // namespace

std::optional<PlotResult> evaluate_plot(const Plot& plot, std::size_t index, const Lesson& lesson,
                                        WorkerContext& worker_context, Diagnostics& diagnostics) {
  const Table* table = nullptr;
  if (!plot.example.text.empty()) {
    table = worker_context.reports_of(plot.example.text)
                .find_table(plot.example, plot.table, *lesson.source, diagnostics);
  }
  if (table != nullptr && (table->empty() || table->front().values.empty())) {
    diagnostics.push_back(error_at(place_of(*lesson.source, plot.table.span()), "E-plot-empty",
                                   "the table `" + plot.table.text + "` has no rows",
                                   "see why " + plot.example.text + " reported none"));
    table = nullptr;
  }
  if (table != nullptr && table->front().values.size() * table->size() > kMostValues) {
    diagnostics.push_back(error_at(
        place_of(*lesson.source, plot.table.span()), "E-plot-size",
        "the table `" + plot.table.text + "` has more than 200000 numbers, too many for a plot",
        "let the example report fewer rows, say every tenth"));
    return std::nullopt;
  }
  auto drawn = worker_context.plot_renderer().draw(plot.json, table ? columns_of(*table) : json(),
                                                   block_name(lesson, index));
  if (!drawn) {
    for (const PlotFault& fault : drawn.error()) {
      const Place place = place_of(*lesson.source, place_of_fault(plot, fault));
      diagnostics.push_back(error_at(place, fault.id, fault.message, fault.cure));
    }
    return std::nullopt;
  }
  if (table == nullptr) return std::nullopt;
  return PlotResult{*std::move(drawn), *table, ""};
}

bool are_plain(const PlotDrawings& drawings, const std::string& name) {
  return is_plain(drawings.wide, name) && (!drawings.narrow || is_plain(*drawings.narrow, name));
}

std::string file_of_example(const std::string& name, const Course& course) {
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks) {
      const auto* example = std::get_if<Example>(&block);
      if (example != nullptr && example->name() == name) return example->file.text;
    }
  }
  return "";
}

}  // namespace mjcourse
