#!/usr/bin/env bash
# Build MuJoCo for the browser, or take what an earlier run built: build.sh [OUT]
#
#   OUT/engine.mjs, OUT/engine.wasm   the engine
#   OUT/licenses/                     of all that is in it
#
# Without OUT it is built for a later run.
#
# The key of a result is a hash of everything it is made from, and the result is kept under it in
# ${XDG_CACHE_HOME:-~/.cache}/mjcourse/engine, the tarballs beside it. Each is made aside and renamed,
# so a kill leaves nothing half done; a lock keeps two runs from doing the same work. Where the
# tarballs cannot be had, OUT is left empty and a warning says why: labs then stay pictures.
set -euo pipefail

out=${1:-}
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
generator=$here/../../../generator
cache=${XDG_CACHE_HOME:-$HOME/.cache}/mjcourse/engine
expected=/usr/include/tl/expected.hpp # of libexpected-dev
toolchain=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake

give_up() {
  echo "mjcourse: warning: labs will be pictures only, for want of MuJoCo for the browser: $*"
  exit 0
}

lines_of() { sed 's/#.*//; /^[[:space:]]*$/d' "$1"; }

mkdir -p "$cache/tarballs"
[ -z "$out" ] || { rm -rf "$out" && mkdir -p "$out"; }
[ -f "$toolchain" ] || give_up "emscripten is not installed"
exec 8>"$cache/.lock"
flock 8
rm -rf "$cache"/.building.* # what a killed run left: nobody else holds the lock
work=$(mktemp -d "$cache/.building.XXXXXX")
trap 'rm -rf "$work"' EXIT

# Everything of ours that goes in is copied first, so that a build sees what the key has hashed.
mkdir -p "$work"/ours/{generator,expected/tl}
cp -r "$here/wasm" "$here/sources.txt" "$work/ours"
lines_of "$here/wasm/generator.txt" | (cd "$generator" && xargs cp --parents -t "$work/ours/generator")
cp "$expected" "$work/ours/expected/tl"
key=$({
  emcc --version | head -n 1
  cd "$work/ours" && find . -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum
} | sha256sum | cut -d ' ' -f 1)
result=$cache/$key

if [ ! -d "$result" ]; then
  while read -r package file sum; do
    tarball=$cache/tarballs/$file
    if ! [ -f "$tarball" ]; then
      echo "fetching $file"
      "$here/fetch.sh" "$package" "$file" "$work" 2>&1 || give_up "$file cannot be fetched"
      mv "$work/$file" "$tarball"
    fi
    echo "$sum  $tarball" | sha256sum --check --quiet || {
      rm -f "$tarball"
      echo "mjcourse: $file is not the file that sources.txt pins" >&2
      exit 1
    }
    mkdir -p "$work/sources/$package"
    tar -xf "$tarball" -C "$work/sources/$package" --strip-components=1
  done < <(lines_of "$here/sources.txt")

  export NODE_PATH=/usr/share/nodejs # where Debian keeps what emscripten's scripts import
  unset EM_CACHE                     # Debian's is complete
  cmake -S "$work/ours/wasm" -B "$work/tree" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$toolchain" \
    -DSOURCES="$work/sources" -DOURS="$work/ours"
  ninja -C "$work/tree" -j "$(nproc)"
  mkdir -p "$work/result/licenses"
  cp "$work/tree"/engine.{mjs,wasm} "$work/result"
  while read -r package license; do
    cp "$work/sources/$package/$license" "$work/result/licenses/$package.txt"
  done < <(lines_of "$here/licenses.txt")
  mv -T "$work/result" "$result"
fi
[ -z "$out" ] || cp -r "$result/." "$out"
