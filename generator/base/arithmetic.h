// How this processor computes: what may differ in its last bits from one to another.
//
// The C library has variants of sine, cosine and their kin for some processors, which round
// otherwise, and so have the libraries that draw. A result is kept for processors of the same kind.
// Tested by tests/generator/process/loaded_libraries_test.cpp.
#pragma once

#include <string>

namespace mjcourse {

// "avx2 fma 1f3a…": what the processor has that libraries look for, and a hash of a few hundred
// values of the functions. The same on all processors that agree in these.
const std::string& arithmetic();

}  // namespace mjcourse
