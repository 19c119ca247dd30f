#!/usr/bin/env bash
# The fuzzers with clang's sanitizers, in a tree of their own.
set -euo pipefail
cmake --preset fuzz
cmake --build --preset fuzz
