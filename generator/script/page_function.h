// An author's script as the page has it: the text of a function, to stand in a module.
//
// It takes from the world only the names that occur in the script. The author's text is whole lines
// between a first and a last one of ours, so that no comment of his can swallow what follows. His
// script stands in a block of its own, where it may give its variables names of the world, as it
// may in a build. That the text closes no bracket of ours, and what it reaches, is known: it is
// what script_guard.h gave.
#pragma once

#include <string>
#include <vector>

namespace mjcourse {

// `names` are those of the world (World::names).
std::string page_script(const std::string& script, const std::vector<std::string>& names);
// Returns the value.
std::string page_expression(const std::string& expression, const std::vector<std::string>& names);
// Sets `target`, which can be assigned to, to the world's `value`.
std::string page_assignment(const std::string& target, const std::vector<std::string>& names);

}  // namespace mjcourse
