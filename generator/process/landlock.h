// Landlock: the kernel's way for a process to give up files, TCP and signals to others.
//
// A ruleset is made while we may still look at every path, and entered as the last but one thing
// before a program begins. Debian 12's headers know the first two of its ABIs, so the rest is spelt
// out in landlock.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mjcourse {

struct LandlockRule {
  std::string path;                          // a file or a folder; passed over where there is none
  enum class Access { read, write } access;  // `read` is to execute as well
};

// The ABI from which on signals stay among those that are confined together.
inline constexpr int kLandlockScopes = 6;
// And the one from which on it knows TCP.
inline constexpr int kLandlockNetwork = 4;

// 0 where the kernel has none, or does not let us. MJCOURSE_LANDLOCK=N, which is for tests of what
// holds on older kernels, makes it N where it is more: it never makes it more than it is. It is
// read from our own environment, of which a course sets nothing.
int landlock_abi();

// Both only for a child between fork and exec; async-signal-safe. A descriptor, or -1. TCP goes to
// these ports alone.
int make_ruleset(int abi, const std::vector<LandlockRule>& rules,
                 const std::vector<std::uint16_t>& ports);
bool enter_ruleset(int ruleset);

}  // namespace mjcourse
