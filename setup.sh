#!/bin/sh
# Installs what is missing of packages.txt and builds a preset. demo.sh and test.sh begin with it.
#   ./setup.sh [release|dev|asan|tsan]
set -eu
cd "$(dirname "$0")"
preset="${1:-release}"

missing_packages() {
  grep -v '^#' packages.txt | while read -r package command; do
    if [ -n "$command" ] && command -v "$command" >/dev/null 2>&1; then continue; fi
    status="$(dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null || true)"
    case "$status" in ii*) ;; *) echo "$package" ;; esac
  done
}

missing="$(missing_packages | tr '\n' ' ')"
if [ -n "$missing" ]; then
  echo "installing Debian packages: $missing"
  as_root=""
  if [ "$(id -u)" -ne 0 ]; then as_root="sudo"; fi
  $as_root apt-get update -qq
  # shellcheck disable=SC2086  # one word a package
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
fi

# configuring again is ninja's business once there is a build folder
if [ ! -f "build/$preset/build.ninja" ]; then
  cmake --preset "$preset" >"/tmp/citykiln-configure-$$.log" 2>&1 || { cat "/tmp/citykiln-configure-$$.log"; exit 1; }
  rm -f "/tmp/citykiln-configure-$$.log"
fi
cmake --build --preset "$preset"
