#!/usr/bin/env bash
# Every source is formatted, and eslint finds nothing in the scripts.
#
#   tests/lint/format.sh NODE
set -uo pipefail
cd "$(dirname "$0")/../.."
node=$1
failed=0

# The programs in tests/accept are cases to the byte.
find generator tests examples -path tests/accept -prune -o \
  \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' -o -name '*.c' \) -print |
  xargs clang-format-16 --dry-run -Werror || failed=1
"$node" site/node_modules/prettier/bin/prettier.cjs --check --log-level warn \
  --config site/.prettierrc.json --ignore-path site/.prettierignore \
  site 'tests/**/*.mjs' || failed=1
"$node" site/node_modules/eslint/bin/eslint.js --config site/eslint.config.mjs site tests || failed=1
exit $failed
