#include "one.h"

const int kThree = kOne + 2;
