#include "physics/mistakes/newer_mjcf.h"

#include <sstream>

namespace mjcourse {
namespace {

// `what` lists the new names of these `elements`, both with a blank between them.
struct Addition {
  const char* version;
  const char* elements;
  const char* what;
};

// From MuJoCo's changelog (doc/changelog.rst of google-deepmind/mujoco) up to version 3.3.3, each
// name held against mj_printSchema() of 2.2.2, which has none of them; `memory` is from the chapter
// on memory of doc/modeling.rst.
constexpr Addition kElements[] = {
    {"2.3.0", "extension plugin", ""},
    {"2.3.7", "jointactuatorfrc", ""},
    {"3.0.0", "deformable flex flexcomp camprojection", ""},
    {"3.1.0", "frame", ""},
    {"3.1.5", "replicate", ""},
    {"3.1.6", "normal fromto", ""},
    {"3.2.0", "attach", ""},
    {"3.2.5", "layer", ""},
    {"3.3.0", "e_potential e_kinetic", ""},
    {"3.3.1", "tendonactuatorfrc", ""},
};

constexpr Addition kAttributes[] = {
    {"2.3.0", "size", "memory"},
    {"2.3.0", "compiler", "assetdir"},
    {"2.3.0", "global", "realtime"},
    {"2.3.0", "composite", "initial vertex"},
    {"2.3.1", "body", "gravcomp"},
    {"2.3.1", "general", "actdim"},
    {"2.3.3", "lengthrange", "interval"},
    {"2.3.4", "global", "ellipsoidinertia"},
    {"2.3.6", "pair", "solreffriction"},
    {"2.3.6", "muscle", "tausmooth"},
    {"2.3.7", "hfield mesh texture", "content_type"},
    {"2.3.7", "joint", "actuatorforcerange actuatorforcelimited"},
    {"3.0.0", "joint", "actuatorfrcrange actuatorfrclimited"},
    {"3.0.0", "general", "actearly"},
    {"3.0.0", "flag", "eulerdamp invdiscrete island"},
    {"3.0.0", "option", "ls_iterations ls_tolerance"},
    {"3.0.0", "camera", "resolution focal focalpixel principal principalpixel sensorsize"},
    {"3.0.1", "option", "actuatorgroupdisable"},
    {"3.1.0", "position intvelocity", "kv"},
    {"3.1.2", "global", "bvactive"},
    {"3.1.2", "rgba", "bv bvactive"},
    {"3.1.2", "hfield", "elevation"},
    {"3.1.3", "position intvelocity", "inheritrange"},
    {"3.1.4", "joint", "actuatorgravcomp"},
    {"3.1.5", "light", "bulbradius"},
    {"3.1.5", "material", "metallic roughness"},
    {"3.1.6", "position", "timeconst"},
    {"3.1.6", "position intvelocity", "dampratio"},
    {"3.2.0", "camera global", "orthographic"},
    {"3.2.0", "mesh", "maxhullvert"},
    {"3.2.1", "flag", "autoreset"},
    {"3.2.3", "option", "ccd_iterations ccd_tolerance"},
    {"3.2.3", "flag", "nativeccd"},
    {"3.2.3", "connect weld", "site1 site2"},
    {"3.2.3", "compiler", "alignfree"},
    {"3.2.3", "freejoint", "align"},
    {"3.2.5", "mesh", "inertia"},
    {"3.3.1", "compiler", "saveinertial"},
    {"3.3.1", "composite", "quat"},
    {"3.3.1", "tendon spatial fixed", "armature actuatorfrcrange actuatorfrclimited"},
    {"3.3.3", "light", "type"},
};

constexpr Addition kKeywords[] = {
    {"2.3.0", "composite", "cable"},
    {"2.3.3", "option", "implicitfast"},
    {"3.0.0", "geom", "sdf"},
    {"3.0.0", "general", "filterexact"},
};

bool lists(const char* words, const std::string& word) {
  std::istringstream text(words);
  for (std::string one; text >> one;) {
    if (one == word) return true;
  }
  return false;
}

template <typename Additions>
std::string version_of(const Additions& additions, const std::string& element,
                       const std::string& what) {
  for (const Addition& addition : additions) {
    const bool is_it = what.empty() || lists(addition.what, what);
    if (is_it && lists(addition.elements, element)) return addition.version;
  }
  return "";
}

}  // namespace

std::string since_when_element(const std::string& element) {
  return version_of(kElements, element, "");
}

std::string since_when_attribute(const std::string& element, const std::string& attribute) {
  return attribute.empty() ? "" : version_of(kAttributes, element, attribute);
}

std::string since_when_keyword(const std::string& element, const std::string& keyword) {
  return keyword.empty() ? "" : version_of(kKeywords, element, keyword);
}

}  // namespace mjcourse
