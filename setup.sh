#!/bin/sh
# Installs packages and builds a preset of CMakePresets.json. demo.sh and test.sh start with it.
#   ./setup.sh [PRESET [GROUP…]]
# PRESET is release unless given. The group "build" of packages.txt is always installed; GROUP names others. The group
# "test" also builds the tests, without it the program alone is built. Both share their object files.
set -eu
cd "$(dirname "$0")"
preset="${1:-release}"
[ $# -eq 0 ] || shift
case " $* " in
  *" test "*) tests=ON target=all what="citykiln and its tests" ;;
  *) tests=OFF target=citykiln what=citykiln ;;
esac
[ "$preset" = release ] || what="$what ($preset)"

# The packages of the groups that are not installed yet.
missing_packages() {
  awk -v groups=" build $* " '/^\[/ {wanted = index(groups, " " substr($0, 2, length($0) - 2) " ")} wanted && /^[a-z]/' packages.txt |
    while read -r package command; do
      if [ -n "$command" ] && command -v "$command" >/dev/null 2>&1; then continue; fi
      status="$(dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null || true)"
      case "$status" in ii*) ;; *) echo "$package" ;; esac
    done
}

missing="$(missing_packages "$@" | tr '\n' ' ')"
if [ -n "$missing" ]; then
  echo "installing Debian packages: $missing"
  as_root=""
  if [ "$(id -u)" -ne 0 ]; then as_root="sudo"; fi
  $as_root apt-get update -qq
  # shellcheck disable=SC2086  # one word for each package
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
fi

# True if the build folder is missing, older than the presets, or lacks tests that are wanted. Whenever CMakeLists.txt
# changes, ninja runs cmake by itself.
needs_configuring() {
  [ -f "build/$preset/build.ninja" ] || return 0
  [ -z "$(find CMakePresets.json -newer "build/$preset/build.ninja")" ] || return 0
  [ "$tests" = ON ] && grep -q '^CITYKILN_TESTS:BOOL=OFF' "build/$preset/CMakeCache.txt"
}
if needs_configuring; then
  echo "configuring build/$preset"
  log="$(mktemp)"
  cmake --preset "$preset" "-DCITYKILN_TESTS=$tests" >"$log" 2>&1 || { cat "$log"; rm -f "$log"; exit 1; }
  rm -f "$log"
fi

# Prints the seconds as a time to wait.
time_left() {
  if [ "$1" -lt 60 ]; then echo "less than a minute left"
  elif [ "$1" -lt 90 ]; then echo "about 1 minute left"
  else echo "about $((($1 + 30) / 60)) minutes left"; fi
}

# Replaces ninja's status lines by one line of progress: rewritten on a terminal, else printed every 30 seconds.
# Everything else, such as compiler errors, passes unchanged. Returns the status in the last line.
show_progress() {
  open_line=no next_s=0 total=0 elapsed_s=0
  while IFS= read -r line; do
    case "$line" in
      "@progress "*)
        # shellcheck disable=SC2086  # the words are: @progress, finished steps, all steps, seconds, what ninja prints
        set -- $line
        [ "$3" -ge 3 ] || continue
        total="$3" elapsed_s="${4%.*}"
        text="building $what, $2 of $3 files"
        if [ "$elapsed_s" -ge 10 ] && [ "$2" -lt "$3" ]; then text="$text, $(time_left $((elapsed_s * ($3 - $2) / $2)))"; fi
        if [ -t 1 ]; then
          printf '\r\033[K%s' "$text"
          open_line=yes
        elif [ "$elapsed_s" -ge "$next_s" ]; then
          echo "$text"
          next_s=$((elapsed_s + 30))
        fi
        ;;
      "@status "*) status="${line#@status }" ;;
      "ninja: no work to do." | "ninja: Entering directory"* | "-- "*) ;;
      *)
        [ "$open_line" = no ] || echo
        open_line=no
        printf '%s\n' "$line"
        ;;
    esac
  done
  [ "$open_line" = no ] || echo
  if [ "$status" -eq 0 ] && [ "$total" -gt 0 ]; then
    echo "built $what: $total files in $((elapsed_s / 60)) min $((elapsed_s % 60)) s"
  fi
  return "$status"
}

export NINJA_STATUS="@progress %f %t %e "
{ cmake --build "build/$preset" --target "$target" 2>&1 && echo "@status 0" || echo "@status $?"; } | show_progress
