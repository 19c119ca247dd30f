// The data of site/press/templates/verification.hbs, whose own comment describes it.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mjcourse {

// A pinned picture beside what was drawn now: addresses below the page.
struct ShownPicture {
  std::string name;
  std::string reference, actual, difference;
  bool agrees = true;
};

// What a page of its own has beside the claims; a site, which is built only without mistakes, has
// none of it.
struct Findings {
  std::map<std::string, std::vector<std::string>>
      of_claim;                     // messages of what is not proved, by its id
  std::vector<std::string> others;  // those that no such claim has a part in
  std::vector<ShownPicture> pictures;
};

// `verification` as in page/html/verification.h. Claims lead to the pages of their lessons only
// where these are, which `links` says.
nlohmann::json verification_data(const nlohmann::json& verification, bool links,
                                 const Findings& findings);

}  // namespace mjcourse
