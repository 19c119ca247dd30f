// The definitions of what eigen.hpp declares. Linked to the programs that have the precompiled
// header.
#define MJC_EIGEN template
#include "eigen.hpp"
