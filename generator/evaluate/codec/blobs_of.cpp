#include "evaluate/codec/blobs_of.h"

#include <variant>

#include "base/any_of.h"

namespace mjcourse {
namespace {

struct BlobsOf {
  std::vector<Blob*>& found;

  void operator()(Poster& poster) { found.insert(found.end(), {&poster.webp, &poster.png}); }
  void operator()(std::optional<Poster>& poster) {
    if (poster) (*this)(*poster);
  }
  void operator()(std::optional<PinComparison>& pin) {
    if (pin) found.insert(found.end(), {&pin->reference, &pin->actual, &pin->difference});
  }
  void operator()(FigureResult& figure) {
    (*this)(figure.poster);
    found.push_back(&figure.film);
    (*this)(figure.pin);
  }
  void operator()(LabResult& lab) {
    (*this)(lab.poster);
    (*this)(lab.pin);
  }
  template <AnyOf<FormulaResult, ValueResult, ExampleResult, ExerciseResult, ModelResult,
                  OutputResult, ImageResult, PlotResult, QuizResult>
                Other>
  void operator()(Other&) {}
};

}  // namespace

std::vector<Blob*> blobs_of(Finding& finding) {
  std::vector<Blob*> blobs;
  BlobsOf collect{blobs};
  for (auto& [block, result] : finding.results) std::visit(collect, result);
  if (finding.model_page) collect(finding.model_page->poster);
  return blobs;
}

}  // namespace mjcourse
