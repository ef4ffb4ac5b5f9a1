#!/bin/sh
# Sets everything up and runs the tests: unit, properties, golden, real. --full adds interop, the sanitizers and fuzzing.
set -eu
cd "$(dirname "$0")"

full=no
for argument in "$@"; do
  case "$argument" in
    --full) full=yes ;;
    *) echo "usage: ./test.sh [--full]" >&2; exit 2 ;;
  esac
done

./setup.sh release

# readers that are not ours, pinned by a lock file; without npm or a registry their tests say that they are skipped
if command -v npm >/dev/null 2>&1 && [ -f tests/interop/package-lock.json ] && [ ! -d tests/interop/node_modules ]; then
  npm ci --prefix tests/interop --silent --no-audit --no-fund || echo "npm ci failed: tests with the glTF validator are skipped"
fi

jobs="$(nproc)"
if [ "$full" = no ]; then
  ctest --test-dir build/release -j "$jobs" --output-on-failure -LE 'interop|fuzz'
  exit
fi

# the sanitizers see units only: the whole way under them would take hours
export TSAN_OPTIONS="suppressions=$PWD/tests/tsan.supp"
for preset in asan tsan; do
  ./setup.sh "$preset"
  # all threads of a written picture are OpenImageIO's, which the thread sanitizer knows nothing about
  ctest --test-dir "build/$preset" -j "$jobs" --output-on-failure -L unit -E "$([ "$preset" = tsan ] && echo WriteImage || echo '^$')"
done
ctest --test-dir build/release -j "$jobs" --output-on-failure
