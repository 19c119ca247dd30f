#include "findings/tally.h"

namespace mjcourse {
namespace {

// Where a proved claim of this kind is counted; null for what no tally counts.
int Tally::*counter_of(Claim::Kind kind) {
  switch (kind) {
    case Claim::Kind::program:
      return &Tally::programs;
    case Claim::Kind::page:
      return &Tally::in_page;
    case Claim::Kind::exercise:
      return &Tally::exercises;
    case Claim::Kind::snippet:
      return &Tally::snippets;
    case Claim::Kind::commands:
      return &Tally::commands;
    case Claim::Kind::output:
      return &Tally::outputs;
    case Claim::Kind::listing:
      return &Tally::listed_models;
    case Claim::Kind::value:
      return &Tally::values;
    case Claim::Kind::formula:
      return &Tally::formulas;
    case Claim::Kind::lab:
      return &Tally::labs;
    case Claim::Kind::picture:
      return &Tally::pictures;
    case Claim::Kind::plot:
      return &Tally::plots;
    case Claim::Kind::answer:
      return &Tally::answers_proved;
    case Claim::Kind::region:  // of a program that was counted
    case Claim::Kind::citation:
    case Claim::Kind::image:
    case Claim::Kind::code:
      return nullptr;
  }
  return nullptr;
}

}  // namespace

Tally tally_of(const Claims& claims) {
  Tally tally;
  for (const Claim& claim : claims) {
    // A program that no page runs was run all the same.
    if (claim.status == Claim::Status::unchecked && claim.kind != Claim::Kind::page) {
      ++tally.unchecked;
    }
    if (claim.status == Claim::Status::asserted && claim.kind == Claim::Kind::answer) {
      ++tally.answers_asserted;
    }
    int Tally::*const counter = counter_of(claim.kind);
    if (claim.status == Claim::Status::proved && counter != nullptr) ++(tally.*counter);
  }
  return tally;
}

Tally& Tally::operator+=(const Tally& other) {
  formulas += other.formulas;
  programs += other.programs;
  in_page += other.in_page;
  exercises += other.exercises;
  snippets += other.snippets;
  commands += other.commands;
  outputs += other.outputs;
  values += other.values;
  listed_models += other.listed_models;
  unchecked += other.unchecked;
  answers_proved += other.answers_proved;
  answers_asserted += other.answers_asserted;
  labs += other.labs;
  pictures += other.pictures;
  plots += other.plots;
  return *this;
}

}  // namespace mjcourse
