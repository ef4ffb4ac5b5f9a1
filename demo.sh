#!/bin/sh
# Sets everything up and runs the main job: the embedded town becomes a manifest, glTF tiles and a picture, in out/town.
# What is up to date is not made again.
set -eu
cd "$(dirname "$0")"
./setup.sh release

citykiln=build/release/citykiln
town=examples/town
out=out/town

# true where $1 is there and nothing that it is made of is newer
is_fresh() {
  made="$1"
  shift
  [ -f "$made" ] && [ -z "$(find "$@" -newer "$made" -print -quit)" ]
}

if ! is_fresh "$out/report.json" "$citykiln" "$town"; then
  "$citykiln" compile --spec "$town/spec.json" -o "$out"
fi
if ! is_fresh "$out/preview.png" "$citykiln" "$out/report.json"; then
  "$citykiln" preview "$out" --level 0 --view low --size 1280x720 --spp 64 -o "$out/preview.png"
fi

echo
echo "made in $out:"
echo "  scene.kiln   the manifest: every object's recipe       $(wc -c <"$out/scene.kiln") bytes"
echo "  glb/         $(find "$out/glb" -name '*.glb' | wc -l) glTF tiles, <x>_<y>_L<level>.glb       $(cat "$out"/glb/*.glb | wc -c) bytes"
echo "  report.json  what was made, mended and dropped"
echo "  timing.json  time and memory by stage"
echo "  preview.png  a picture of it"
