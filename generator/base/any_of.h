// AnyOf: what a visitor passes over, kind by kind.
//
// A catch-all would swallow a kind that is added later; this is an error of the compiler's there,
// which names the kind:
//
//   template <AnyOf<Io, Demo> Other>
//   void operator()(const Other&) {}
#pragma once

#include <concepts>

namespace mjcourse {

template <typename Kind, typename... Kinds>
concept AnyOf = (std::same_as<Kind, Kinds> || ...);

}  // namespace mjcourse
