#!/bin/sh
# Builds citykiln, compiles the example town to a manifest and glTF tiles in out/town, and renders a picture of it.
# Outputs that are up to date are not made again. CITYKILN_DEMO_SIZE sets the size of the picture, 1280x720 unless given.
set -eu
cd "$(dirname "$0")"
./setup.sh

citykiln=build/release/citykiln
town=examples/town
out=out/town

# True if file $1 exists and none of the other arguments is newer.
is_fresh() {
  made="$1"
  shift
  [ -f "$made" ] && [ -z "$(find "$@" -newer "$made" -print -quit)" ]
}

# Runs a command and says how long it took: timed "what it does" COMMAND…
timed() {
  echo
  echo "$1"
  shift
  start_s="$(date +%s)"
  "$@"
  echo "done in $(($(date +%s) - start_s)) s"
}

if ! is_fresh "$out/report.json" "$citykiln" "$town"; then
  timed "compiling the map $town/town.osm" \
    "$citykiln" compile --spec "$town/spec.json" --tags -o "$out"
fi
if ! is_fresh "$out/preview.png" "$citykiln" "$out/report.json"; then
  timed "rendering a picture" \
    "$citykiln" preview "$out" --level 0 --view low --size "${CITYKILN_DEMO_SIZE:-1280x720}" --spp 8 -o "$out/preview.png"
fi

megabytes() { cat "$@" | wc -c | awk '{printf "%.1f MB", $1 / 1e6}'; }
cat <<END

Files in $out:
  preview.png   a picture of the town
  glb/          $(find "$out/glb" -name '*.glb' | wc -l) glTF tiles, $(megabytes "$out"/glb/*.glb): <x>_<y>_L<level>.glb, level 0 (0.1 m) is the finest
  scene.kiln    the manifest, $(megabytes "$out/scene.kiln"): a recipe for every object
  report.json   counts of objects, and what was repaired or dropped
  findings.json every finding with its place, for QGIS
  timing.json   time and memory of each stage

What to open next:
  the picture   xdg-open $out/preview.png
  in a browser  drag $out/glb/0_0_L1.glb onto https://gltf-viewer.donmccurdy.com or https://sandbox.babylonjs.com
  in Blender    $citykiln addon blender -o citykiln.zip; install it, then File > Import > citykiln run, and choose $out
  your own map  $citykiln compile MAP.osm.pbf -o out/mine
  fly over it   $citykiln view $out   (prints the address of a page for the browser)
END
