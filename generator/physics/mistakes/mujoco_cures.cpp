#include "physics/mistakes/mujoco_cures.h"

#include <re2/re2.h>

#include <array>

namespace mjcourse {
namespace {

struct Cure {
  const char* message;  // a regular expression; what an author named stands in \1
  const char* cure;
};

// Of the numbers of one element.
constexpr auto kOfNumbers = std::to_array<Cure>({
    {R"(problem reading attribute '(\w+)')", R"(write numbers in `\1`, with spaces between them)"},
    {R"(attribute '(\w+)' has too much data)", R"(write fewer numbers in `\1`)"},
    {R"(attribute '(\w+)' does not have enough data)", R"(write more numbers in `\1`)"},
    {R"(required attribute missing: '(\w+)')", R"(write `\1="…"` there)"},
    {R"(user has more values than (nuser_\w+) in)",
     R"(write how many values there are, as `<size \1="3"/>`, or fewer values)"},
    {R"((nuser_\w+) must be >= -1)", R"(leave `\1` out, and MuJoCo finds it)"},
    {"invalid activation range for actuator",
     "write `actrange=\"0 1\"`, with the lower number first"},
    {"invalid control range for actuator",
     "write `ctrlrange=\"0 1\"`, with the lower number first"},
    {"invalid force range for actuator", "write `forcerange=\"0 1\"`, with the lower number first"},
    {"invalid limits in", "write `range=\"0 1\"`, with the lower number first"},
    {"actrange specified but dyntype is 'none'",
     "leave `actrange` out, or give the actuator a state, as `dyntype=\"filter\"`"},
    {"(?:damper|adhesion) control range cannot be negative",
     "write a `ctrlrange` from 0 on, as \"0 1\""},
    {"damping coefficient cannot be negative", "write a `kv` of 0 or more"},
    {"adhesion gain cannot be negative", "write a `gain` of 0 or more"},
    {"skin group must be between 0 and 5", "write a group from 0 to 5"},
    {"axis too small in joint", "write an axis that is not zero, as `axis=\"0 0 1\"`"},
    {"sizes must be positive in object", "write `size` in numbers greater than 0"},
    {R"(plane size\(3\) must be positive)", "write a third number in `size`, greater than 0"},
    {"fromto points too close", "write two points that lie apart"},
    {"mass, inertia or density are negative|mass and inertia cannot be negative",
     "write 0 or more"},
    {"euler format must have length 3", "write three letters, as `eulerseq=\"xyz\"`"},
});

// Of how elements belong together.
constexpr auto kOfStructure = std::to_array<Cure>({
    {"mass and inertia of moving bodies must be larger than mjMINVAL",
     "give the body a geom that has a mass, or an `<inertial>`"},
    {"inertia must satisfy A \\+ B >= C",
     "write the inertia of a real body, or `<compiler balanceinertia=\"true\"/>`"},
    {"multiple orientation specifiers",
     "keep one of `quat`, `axisangle`, `euler`, `xyaxes`, `zaxis` and `fullinertia`"},
    {"refname '.*' given but reftype is missing",
     "say what kind of thing that is, as `reftype=\"site\"`"},
    {"missing name of reference frame object", "name it by `refname`, or leave `reftype` out"},
    {"unrecognized name of reference frame object",
     "look at `refname`: nothing of its `reftype` has that name"},
    {R"((mesh|hfield|material|texture|site|body|geom|transmission target|reference site|base site) )"
     R"('.*' not found in)",
     R"(nothing in the model has that name: look for a wrong letter, or define the \1)"},
    {R"(unknown (?:element|body) '.*' in|unknown target body in|unrecognized object '.*' in)",
     "nothing in the model has that name: look for a wrong letter, or define it"},
    {"reference frame object must be", "write one of these as `reftype`"},
    {"stateless actuators must come before stateful actuators",
     "write those with an activation, as `<intvelocity>`, after all others"},
    {"missing name of sensorized object", "name it by `objname`"},
    {"unrecognized name of sensorized object",
     "look at what the sensor names: nothing in the model has that name"},
    {R"(repeated name in \w+ array)", "give each a name of its own"},
    {"repeated default class name", "give each class a name of its own"},
    {"unknown default (?:child)?class", "define it: `<default><default class=\"NAME\">…`"},
    {"free joint can only be used on top level", "put the body right into `<worldbody>`"},
    {"free joint can only appear by itself", "take the body's other joints out"},
    {"more than 6 dofs in body|ball followed by rotation in body",
     "give some of its joints a body of their own"},
    {"World body cannot have (joints|inertia|attributes)", R"(write the \1 of a `<body>` in it)"},
    {"plane and hfield only allowed in static bodies",
     "put the geom into `<worldbody>`, or into a body without joints"},
    {"mocap body '.*' is not a fixed child of world",
     "put it right into `<worldbody>`, and give it no joint"},
    {"(joint|tendon) must be limited in sensor", R"(give the \1 a `range`, and `limited="true"`)"},
    {"spatial path must contain at least two objects", "give the tendon two sites or more"},
    {"actuator can have at most one of transmission target",
     "keep one of `joint`, `jointinparent`, `tendon`, `site`, `body` and `cranksite`"},
    {R"(repeated element: '(\w+)')", R"(keep one `<\1>`)"},
    {"File '.*' already included", "include each file once"},
});

// Of meshes, whose numbers stand in other files.
constexpr auto kOfMeshes = std::to_array<Cure>({
    {"faces have inconsistent orientation",
     "let all faces go round the same way: a program for meshes can recompute their normals"},
    {"mesh surface area is too small", "look at the mesh's vertices and at its `scale`"},
    {"mesh volume is too small",
     "a flat mesh has a surface alone: write `shellinertia=\"true\"` in its geom; else look at its "
     "vertices and its `scale`"},
    {"at least 4 verices required", "a mesh has four vertices or more"},
    {"qhull error", "look at the mesh's vertices: they may all lie in one plane"},
});

template <std::size_t Count>
std::string cure_among(const std::array<Cure, Count>& cures, const std::string& message) {
  for (const Cure& known : cures) {
    std::string cure;
    if (RE2::Extract(message, known.message, known.cure, &cure)) return cure;
  }
  return "";
}

}  // namespace

std::string cure_of_model(const std::string& message) {
  std::string cure = cure_among(kOfNumbers, message);
  if (cure.empty()) cure = cure_among(kOfStructure, message);
  return cure.empty() ? cure_among(kOfMeshes, message) : cure;
}

}  // namespace mjcourse
