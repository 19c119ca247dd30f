#include "evaluate/result_fits.h"

#include <algorithm>
#include <variant>

#include "base/any_of.h"
#include "base/beneath.h"
#include "base/plain_name.h"
#include "base/utf8.h"
#include "findings/model_page.h"
#include "physics/model_files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

bool has_parts_of(const Lab& lab, const LabRunResult& run) {
  std::size_t traces = 0;
  for (const Lab::Plot& plot : lab.plots) traces += plot.traces.size();
  return (!run.control || *run.control < lab.controls.size()) &&
         std::ranges::all_of(run.readings, [&](const LabReading& reading) {
           return reading.values.size() == lab.readouts.size() &&
                  reading.ghost.size() == (lab.ghost ? traces : 0);
         });
}

bool has_parts_of(const Lab& lab, const LabResult& result) {
  if (lab.readouts.size() != result.readouts.size() || lab.plots.size() != result.traces.size() ||
      lab.controls.size() != result.keyframes.size()) {
    return false;
  }
  for (std::size_t i = 0; i < lab.plots.size(); ++i) {
    if (lab.plots[i].traces.size() != result.traces[i].size()) return false;
  }
  return std::ranges::all_of(result.runs,
                             [&](const LabRunResult& run) { return has_parts_of(lab, run); });
}

// Which become names of a page's script.
bool are_names(const std::vector<std::string>& names) {
  return std::ranges::all_of(names, [](const std::string& name) {
    return !name.empty() && !is_digit(name[0]) &&
           std::ranges::all_of(name, [](char c) { return is_word_character(c) || c == '$'; });
  });
}

// Which become names in a reader's archive.
bool are_paths(const std::vector<std::string>& files) {
  return std::ranges::none_of(files, [](const std::string& file) {
    return fault_of_path(file, Hidden::is_allowed).has_value();
  });
}

// Which becomes a part of a file's name.
bool is_hash(const std::string& hash) {
  return !hash.empty() && std::ranges::all_of(hash, is_word_character);
}

bool is_pinned_as(const LocatedText& pin, const std::optional<PinComparison>& found) {
  return !found || found->name == pin.text;
}

bool is_of(const Lab& lab, const LabResult& result) {
  return has_parts_of(lab, result) && are_names(result.script_names) &&
         is_pinned_as(lab.pin, result.pin);
}

// Are its columns equally long?
bool is_table(const Table& table) {
  return std::ranges::all_of(table, [&](const Column& column) {
    return column.values.size() == table.front().values.size();
  });
}

struct Fits {
  const Result& result;

  template <typename Kind>
  bool is() const {
    return std::holds_alternative<Kind>(result);
  }
  bool operator()(const Math&) const { return is<FormulaResult>(); }
  bool operator()(const InlineValue&) const { return is<ValueResult>(); }
  bool operator()(const Example&) const { return is_taken_program(); }
  // Its solution is a program, where no fence shows it.
  bool operator()(const Exercise&) const {
    const auto* known = std::get_if<ExerciseResult>(&result);
    return known != nullptr ? are_paths(known->files) : is_taken_program();
  }
  bool operator()(const ModelExcerpt&) const { return is<ModelResult>(); }
  bool operator()(const InlineModel&) const { return is<ModelResult>(); }
  bool operator()(const Output&) const { return is<OutputResult>(); }
  bool operator()(const Image&) const {
    const auto* known = std::get_if<ImageResult>(&result);
    return known != nullptr && is_hash(known->hash);
  }
  bool operator()(const Figure& figure) const {
    const auto* known = std::get_if<FigureResult>(&result);
    return known != nullptr && is_pinned_as(figure.pin, known->pin);
  }
  bool operator()(const Plot&) const {
    const auto* known = std::get_if<PlotResult>(&result);
    return known != nullptr && is_table(known->table);
  }
  bool operator()(const Lab& lab) const {
    const auto* known = std::get_if<LabResult>(&result);
    return known != nullptr && is_of(lab, *known);
  }
  bool operator()(const Quiz& quiz) const {
    const auto* known = std::get_if<QuizResult>(&result);
    return known != nullptr && known->questions.size() == quiz.questions.size();
  }
  bool operator()(const Snippet&) const { return is_taken_program(); }
  bool operator()(const Commands&) const { return is_program(); }
  template <AnyOf<TermUse, Unchecked, Io, Callout, Demo, Shown> Other>
  bool operator()(const Other&) const {
    return false;
  }

  // One that a reader can take along.
  bool is_taken_program() const {
    const auto* known = std::get_if<ExampleResult>(&result);
    return known != nullptr && are_paths(known->files) && is_program();
  }
  bool is_program() const {
    const auto* known = std::get_if<ExampleResult>(&result);
    return known != nullptr && std::ranges::all_of(known->records.tables, [](const auto& named) {
             return is_table(named.second);
           });
  }
};

bool lie_in(const fs::path& root, const LabResult& lab) {
  return std::ranges::all_of(lab.model.assets, [&](const auto& asset) {
    const fs::path& path = asset.second;
    const auto name = name_beneath(root, path);
    return is_name_of_asset(asset.first) && path == path.lexically_normal() && name &&
           is_inert(root, *name);
  });
}

bool lies_in(const fs::path& root, const Result& result) {
  const auto* lab = std::get_if<LabResult>(&result);
  return lab == nullptr || lie_in(root, *lab);
}

// A lab that can be shown, and files that the site may have.
bool is_page_of(const Task& task, const ModelPage& page, const fs::path& root) {
  const bool has_own_files = std::ranges::all_of(page.files, [&](const ModelPage::File& file) {
    const fs::path path = file.path;
    return path == path.lexically_normal() && path.is_relative() && *path.begin() == "models" &&
           is_inert(root, file.path);
  });
  if (page.name != task.model() || !has_own_files) return false;
  if (!page.lab) return true;
  const Lesson& lesson = *page.lab->lesson;
  return lesson.number == page.name && lesson.blocks.size() == 1 &&
         fits(lesson.blocks.front(), page.lab->result) && lie_in(root, page.lab->result);
}

}  // namespace

bool fits(const Task& task, const Finding& finding, const fs::path& root) {
  const std::vector<std::size_t> blocks = task.blocks();
  const std::vector<Block>& all = task.lesson().blocks;
  return std::ranges::all_of(finding.results,
                             [&](const auto& found) {
                               const auto& [block, result] = found;
                               return std::ranges::count(blocks, block) > 0 && block < all.size() &&
                                      fits(all[block], result) && lies_in(root, result);
                             }) &&
         std::ranges::all_of(finding.pages,
                             [&](const auto& found) {
                               return std::ranges::count(blocks, found.first) > 0 &&
                                      found.first < all.size();
                             }) &&
         (!finding.model_page || is_page_of(task, *finding.model_page, root));
}

bool fits(const Block& block, const Result& result) {
  return std::visit(Fits{result}, block);
}

bool fits(const Block& block, const LabResult& result) {
  const auto* lab = std::get_if<Lab>(&block);
  return lab != nullptr && is_of(*lab, result);
}

}  // namespace mjcourse
