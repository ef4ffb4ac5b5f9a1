#!/bin/sh
# Builds the program and the tests, and runs the tests that answer in minutes: unit, properties, golden.
# --full also runs what takes longer, in groups; --full GROUP… runs these groups alone:
#   budget    what five maps weigh, against tests/budget/table.tsv
#   real      the tests on real maps and heights, in ../shared/data; skipped where that folder is absent
#   long      the tests labelled full: large maps, clusters, a desktop window; unit tests with more rounds
#   interop   programs of others that read the outputs: Blender, Godot, Chromium, validators
#   lint      each source compiled alone, warnings are errors; clang-tidy
#   clang     the program built with clang++, which gives the golden outputs
#   asan      the unit tests under the address and undefined-behaviour sanitizers
#   tsan      the unit tests under the thread sanitizer
#   bench     the benchmarks run, tools and fuzz programs compile
#   clones    both commands in clones whose paths are short, long, or hold a space and an umlaut
# CITYKILN_TURN=N runs an eighth of real, lint or bench, another one for each N, as .ci/run does.
set -eu
cd "$(dirname "$0")"

all_groups="budget real long interop lint clang asan tsan bench clones"
groups="" runs_quick=yes
for argument in "$@"; do
  case " --full $all_groups " in
    *" $argument "*) [ "$argument" = --full ] || groups="$groups $argument" ;;
    *) echo "usage: ./test.sh [--full [$(echo "$all_groups" | tr ' ' '|')]…]" >&2; exit 2 ;;
  esac
done
if [ $# -gt 0 ]; then
  [ "$1" = --full ] || { echo "groups follow --full" >&2; exit 2; }
  if [ -n "$groups" ]; then runs_quick=no; else groups="$all_groups"; fi
fi

# Readers of tiles, at the versions in the lock file; without npm or its registry, tests with them are skipped.
# install_readers [OPTION]: --omit=optional leaves out CesiumJS and 3DTilesRendererJS, which are large.
install_readers() {
  command -v npm >/dev/null 2>&1 || return 0
  npm ci --prefix tests/interop "$@" --silent --no-audit --no-fund || echo "npm ci failed: tests with the glTF validator are skipped"
}

# Readers from PyPI (OpenUSD, its validator, Blender as a module), at the versions of requirements.txt, in build/interop; where they
# cannot be installed, tests with them are skipped.
install_python_readers() {
  wanted=tests/interop/requirements.txt kept=build/interop/requirements.txt
  cmp -s "$wanted" "$kept" && return 0
  mkdir -p build
  if python3 -m venv build/interop && build/interop/bin/pip install --quiet --only-binary :all: -r "$wanted"; then
    cp "$wanted" "$kept"
  else
    echo "pip install failed: tests with OpenUSD and Blender 4 are skipped"
  fi
}

# run_tests PRESET OPTIONS… runs the tests that ctest's options choose.
run_tests() {
  preset="$1"
  shift
  ctest --test-dir "build/$preset" -j "$(nproc)" --output-on-failure "$@"
}

run_quick() {
  ./setup.sh release test
  [ -d tests/interop/node_modules ] || install_readers --omit=optional
  run_tests release -LE 'full|interop|real|budget'
}

# shellcheck disable=SC2086  # two words or none
run_real() {
  turn="${CITYKILN_TURN:-}"
  part="${turn:+-I $((turn % 8 + 1)),,8}"
  ./setup.sh release test
  run_tests release -L real -LE 'full|interop' $part
}

run_budget() {
  ./setup.sh release test budget
  run_tests release -L budget
}

run_long() (
  export CITYKILN_FULL=1
  ./setup.sh release test long
  run_tests release -L 'full|^unit$'
)

run_interop() {
  ./setup.sh release test interop
  [ -d tests/interop/node_modules/cesium ] || install_readers
  install_python_readers
  run_tests release -L interop
}

# Passes the lines on, with CITYKILN_TURN the eighth of that turn.
lines_of_turn() {
  if [ -n "${CITYKILN_TURN:-}" ]; then awk -v turn="$CITYKILN_TURN" 'NR % 8 == turn % 8'; else cat; fi
}

# Compiles sources alone; without CITYKILN_TURN also the programs of them.
compile_alone() {
  if [ -z "${CITYKILN_TURN:-}" ]; then
    ./setup.sh lint test
    return
  fi
  cmake --preset lint >/dev/null
  ninja -C build/lint -t targets all | sed -n 's/\.o: CXX_COMPILER.*/.o/p' | lines_of_turn | xargs ninja -C build/lint --quiet
}

# clang-tidy reads the batches in which release compiles the program, which takes a twelfth of the time of single sources.
# Generated headers, in build, are left out.
run_tidy() {
  sed -n 's/^ *"file": "\(.*\)",*$/\1/p' build/release/compile_commands.json |
    grep -vF -e "$PWD/tests/" -e "$PWD/build/release/tests/" | lines_of_turn |
    xargs -d '\n' -n 1 -P "$(nproc)" clang-tidy --quiet -p build/release --extra-arg=-Wno-unknown-warning-option \
        --header-filter="^$PWD/(compiler|exporters|preview|grammars|lsystems)/"
}

run_lint() {
  ./setup.sh release test lint
  compile_alone
  run_tidy
}

run_clang() {
  ./setup.sh clang clang
  CITYKILN="$PWD/build/clang/citykiln" python3 tests/golden/golden_test.py
}

run_asan() {
  ./setup.sh asan test
  run_tests asan -L '^unit$'
}

# picture writing is left out: the thread sanitizer does not see the locks inside OpenImageIO
run_tsan() (
  export TSAN_OPTIONS="suppressions=$PWD/tests/tsan.supp"
  ./setup.sh tsan test
  run_tests tsan -L '^unit$' -E WriteImage
)

run_bench() {
  ./setup.sh release test
  cmake --build build/release --target citykiln_bench large_extract
  python3 tests/bench/short_run.py ${CITYKILN_TURN:+"$CITYKILN_TURN"}
  # linked by clang++ alone (preset fuzz), which takes long
  for source in $(printf '%s\n' tests/fuzz/*.cpp | lines_of_turn); do
    c++ -std=c++20 -fsyntax-only -DFMT_SHARED -I. -Ibuild/release "$source"
  done
}

# without real data, which lie beside this clone only
run_clones() {
  scratch="$(mktemp -d)"
  long="$(printf 'a-folder-%.0s' 1 2 3 4 5 6 7 8 9 10 11 12 13)"
  for name in c "$long" "a spaced für folder"; do
    git clone -q . "$scratch/$name"
    (cd "$scratch/$name" && ./demo.sh && ./test.sh)
    rm -rf "${scratch:?}/$name"
  done
  rmdir "$scratch"
}

[ "$runs_quick" = no ] || run_quick
for group in $groups; do
  echo "--- $group"
  "run_$group"
done
[ -n "$groups" ] || echo "not run: the budget, real and large maps, clusters, other programs, sanitizers, clang++: ./test.sh --full"
