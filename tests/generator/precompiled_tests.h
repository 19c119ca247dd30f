// What nearly every unit test includes of others, compiled once, as generator/precompiled.h is.
#pragma once

#include <gtest/gtest.h>

#include "precompiled.h"
