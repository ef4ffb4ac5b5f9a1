#!/bin/sh
# Compares the speed, memory and outputs of two revisions: tests/bench/compare.sh BASE [ROUNDS]
# BASE is a commit; it is compared with the working tree. Both are built as a user gets them, BASE in build/compare. Then
# compare_runs.py runs both in turn, ROUNDS times (3), and prints a table in Markdown. Needs ../shared/data.
set -eu
cd "$(dirname "$0")/../.."
[ $# -ge 1 ] || { echo "usage: tests/bench/compare.sh BASE [ROUNDS]" >&2; exit 2; }
commit="$(git rev-parse --short=8 --verify "$1^{commit}")"
base="$PWD/build/compare/$commit"

./setup.sh
if [ ! -x "$base/build/release/citykiln" ]; then
  [ -d "$base/.git" ] || git clone -q --no-checkout . "$base"
  git -C "$base" checkout -q "$commit"
  echo "building $commit"
  # -w: revisions up to 0d60694b end at false warnings
  (cd "$base" && cmake --preset release -DCMAKE_CXX_FLAGS=-w >/dev/null && cmake --build build/release --target citykiln >/dev/null)
fi
exec python3 tests/bench/compare_runs.py "$base/build/release/citykiln" build/release/citykiln "${2:-3}"
