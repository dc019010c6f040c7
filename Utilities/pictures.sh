#!/usr/bin/env bash
# Draws the pictures of Documentation/stipple.md with the headless build: pairs, without and with what they show.
set -euo pipefail

cd "$(dirname "$0")/.."
. Utilities/env.sh headless

work="build/pictures"
images="Documentation/images"
mkdir -p "$work"
"$INK_PYTHON" Utilities/pictures.py mesh Data/engine.nii.gz 80 "$work/engine.ply"

bonsai="Data/bonsai.nii.gz --view front --elevation 12 --percentile 97"
engine="Data/engine.nii.gz --view iso"
block="$work/engine.ply --view iso"

# picture NAME OPTIONS...: one drawing
picture() {
  local name="$1"
  shift
  # shellcheck disable=SC2086
  ink render $* --style stipple --size 320x320 --quiet -o "$work/$name.png"
}

# pair NAME COMMON LEFT RIGHT: two drawings beside each other, as Documentation/images/stipple-NAME.png
pair() {
  picture "$1-0" $2 $3
  picture "$1-1" $2 $4
  "$INK_PYTHON" Utilities/pictures.py join "$images/stipple-$1.png" "$work/$1-0.png" "$work/$1-1.png"
  echo "$images/stipple-$1.png"
}

plain="--interior 0 --distance 0"
pair boundary "$bonsai $plain --silhouette off --pixels-per-stipple 12" "--boundary off" "--boundary 0.1,1.5,1"
pair silhouette "$engine $plain --lighting off --pixels-per-stipple 25" "--silhouette off" "--silhouette 0.3,3,0.3"
pair resolution "$block --lighting off --distance 0 --pixels-per-stipple 16" "--resolution off" "--resolution -2,1"
pair lighting "$block --distance 0" "--lighting off" "--lighting 1"
pair distance "$engine" "--distance 0" "--distance 0.5"
pair size "$engine" "--distance-ks 1,0 --interior-ks 0.3,0" "--distance-ks 1,1 --interior-ks 0.3,1"
pair interior "$bonsai" "--interior 0" "--interior 0.4"
pair color "$block" "" "--color 1"
pair occluder "$engine" "" "--iso 80"
pair parts "$engine --zoom 0.6" "--parts probability" "--parts intensity"
presets=()
for preset in anatomy bone soft-tissue engineering plate-white-on-black; do
  picture "preset-$preset" "$engine" --preset $preset
  presets+=("$work/preset-$preset.png")
done
"$INK_PYTHON" Utilities/pictures.py join "$images/stipple-presets.png" "${presets[@]}"
echo "$images/stipple-presets.png"
