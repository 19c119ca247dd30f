// What stands in a store's files, and in a shared store's entries, for what has a name.
//
// Bytes with a name of their own hash stand there as they are. All others are sealed: behind a line
// with a hash of their name and themselves, so no entry can take another's place.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/store.h"

namespace mjcourse {

// The largest that a store has.
inline constexpr std::size_t kMostEntryBytes = std::size_t{1} << 30;

// Is it one of a store's? It may come out of an entry that anybody wrote, and becomes a path.
bool is_store_name(std::string_view name);

std::string sealed(const std::string& name, std::string_view bytes);

// The bytes in the `entry` of that name; nothing where it is damaged, or another one's.
std::optional<std::string> unsealed(const std::string& name, std::string entry);

// On a disk, the first line says also where the bytes are from.
std::string sealed(const std::string& name, const Stored& stored);
// Of an entry that does not say so, nobody knows; what never leaves a machine was made here.
std::optional<Stored> unsealed_stored(const std::string& name, std::string entry);

// Written by another version of the generator, it is as good as none.
bool is_of_another_version(std::string_view entry);
bool is_stored_by_another_version(std::string_view entry);  // of one on a disk

}  // namespace mjcourse
