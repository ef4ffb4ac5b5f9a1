#!/bin/sh
# Builds the program and the tests, and runs the tests: unit, properties, golden, real.
# --full adds the sanitizers, and readers of glTF that are not part of citykiln.
set -eu
cd "$(dirname "$0")"

full=no
for argument in "$@"; do
  case "$argument" in
    --full) full=yes ;;
    *) echo "usage: ./test.sh [--full]" >&2; exit 2 ;;
  esac
done

# one build for all tests: it is optimised, and its assertions hold for the scripts too
./setup.sh checked test
[ "$full" = no ] || ./setup.sh checked interop

# readers of tiles, at the versions in the lock file; without npm or its registry, tests with them are skipped. The large ones,
# CesiumJS and 3DTilesRendererJS, are optional.
omit=--omit=optional
[ "$full" = no ] || omit=
if command -v npm >/dev/null 2>&1 && [ ! -d tests/interop/node_modules ]; then
  npm ci --prefix tests/interop $omit --silent --no-audit --no-fund || echo "npm ci failed: tests with the glTF validator are skipped"
fi

jobs="$(nproc)"
# run_tests PRESET OPTIONS… runs the tests that ctest's options choose.
run_tests() {
  preset="$1"
  shift
  ctest --test-dir "build/$preset" -j "$jobs" --output-on-failure "$@"
}

if [ "$full" = no ]; then
  run_tests checked -LE interop
  exit
fi
run_tests checked

# the address and thread sanitizers run unit tests only: the others would take hours
./setup.sh asan test
run_tests asan -L '^unit$'
# picture writing is left out: the thread sanitizer does not see the locks inside OpenImageIO
./setup.sh tsan test
export TSAN_OPTIONS="suppressions=$PWD/tests/tsan.supp"
run_tests tsan -L '^unit$' -E WriteImage

# benchmarks and tools must compile
./setup.sh bench test
