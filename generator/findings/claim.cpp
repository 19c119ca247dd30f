#include "findings/claim.h"

namespace mjcourse {

const char* name_of(Claim::Kind kind) {
  switch (kind) {
    case Claim::Kind::program:
      return "program";
    case Claim::Kind::page:
      return "page";
    case Claim::Kind::region:
      return "region";
    case Claim::Kind::exercise:
      return "exercise";
    case Claim::Kind::snippet:
      return "snippet";
    case Claim::Kind::commands:
      return "commands";
    case Claim::Kind::output:
      return "output";
    case Claim::Kind::listing:
      return "listing";
    case Claim::Kind::value:
      return "value";
    case Claim::Kind::formula:
      return "formula";
    case Claim::Kind::lab:
      return "lab";
    case Claim::Kind::picture:
      return "picture";
    case Claim::Kind::plot:
      return "plot";
    case Claim::Kind::image:
      return "image";
    case Claim::Kind::answer:
      return "answer";
    case Claim::Kind::citation:
      return "citation";
    case Claim::Kind::code:
      return "code";
  }
  return "";
}

const char* name_of(Claim::Status status) {
  switch (status) {
    case Claim::Status::proved:
      return "proved";
    case Claim::Status::cited:
      return "cited";
    case Claim::Status::asserted:
      return "asserted";
    case Claim::Status::unchecked:
      return "unchecked";
    case Claim::Status::failed:
      return "failed";
  }
  return "";
}

}  // namespace mjcourse
