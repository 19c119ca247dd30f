// How what a course does computes: the same on all processors, but for drawings.
//
// The C library has variants of sine, cosine and their kin for some processors, which round one
// value in a hundred otherwise, and otherwise than WebAssembly does. So whatever runs in a sandbox
// runs without them (process/launch.cpp). The libraries that draw choose for themselves.
#pragma once

#include <string>

namespace mjcourse {

// A setting of glibc's: a part of the value of GLIBC_TUNABLES.
inline constexpr const char* kOneRounding = "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2";

// "x86_64 glibc.cpu.hwcaps=…": with the versions of the libraries, all that rounding depends on.
const std::string& arithmetic();

// "avx avx2 fma": what the processor has that libraries which draw look for.
const std::string& processor_features();

}  // namespace mjcourse
