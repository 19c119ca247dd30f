#!/usr/bin/env bash
# Bring a file of a Debian source package: fetch.sh PACKAGE FILE FOLDER
#
# It comes from wherever the machine's own apt takes its packages, by a private configuration beside
# the system's: the same sources, asked for source packages, and for those of Debian 12, which has all
# of sources.txt. What arrives is not checked here. Fails when apt cannot bring it.
set -euo pipefail

package=$1 file=$2 folder=$3
private=$(mktemp -d)
trap 'rm -rf "$private"' EXIT
mkdir -p "$private"/{sources.list.d,lists/partial,cache/archives/partial}

# The machine's sources in apt's two formats, made to mean source packages.
list='' parts='' # apt-config sets them
eval "$(apt-config shell list Dir::Etc::sourcelist/f parts Dir::Etc::sourceparts/d)"
for source in "$list" "$parts"/*.list; do
  [ ! -f "$source" ] || sed -nE 's/^[[:space:]]*deb[[:space:]]/deb-src /p' "$source"
done >"$private/sources.list"
for source in "$parts"/*.sources; do
  [ ! -f "$source" ] || sed 's/^Types:.*/Types: deb-src/' "$source" \
    >"$private/sources.list.d/${source##*/}"
done

# A later release's sources lie where Debian 12's do.
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
find "$private" -type f -exec sed -i "s/\b${release:-bookworm}\b/bookworm/g" {} +

export APT_CONFIG=$private/apt.conf
cat >"$APT_CONFIG" <<CONF
Dir::Etc::sourcelist "$private/sources.list";
Dir::Etc::sourceparts "$private/sources.list.d";
Dir::State::lists "$private/lists";
Dir::Cache "$private/cache";
APT::Sandbox::User "root";
Acquire::Retries "1";
Acquire::http::Timeout "20";
Acquire::https::Timeout "20";
CONF

# A source of the machine that has no source packages fails here, which does not matter.
apt-get update -qq || true
uri=$(apt-get source --print-uris -qq "$package" | awk -v file="$file" -F "'" \
  '{ split($3, rest, " ") } rest[1] == file { print $2 }' || true)
[ -n "$uri" ] || {
  echo "apt knows no $file of the source package $package" >&2
  exit 1
}
/usr/lib/apt/apt-helper download-file "$uri" "$folder/$file"
