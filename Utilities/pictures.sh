#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Draws the pictures of Documentation/contours.md, illustration.md, line-art.md, stipple.md, splatting-lines.md, strokes.md and
# picture-quality.md with the headless build, those of one page with its name:
#   Utilities/pictures.sh [contours|illustration|line-art|stipple|splatting-lines|strokes|quality]
# Most are pairs, without and with what they show.
set -euo pipefail

cd "$(dirname "$0")/.."
. Utilities/env.sh headless

work="build/pictures"
images="Documentation/images"
mkdir -p "$work"
"$INK_PYTHON" Utilities/pictures.py mesh Data/engine.nii.gz 80 "$work/engine.ply"
"$INK_PYTHON" Utilities/pictures.py edges "$work/edges.vtp" "$work/sheets.vtp"

# picture NAME OPTIONS...: one drawing, in $style
picture() {
  local name="$1"
  shift
  # shellcheck disable=SC2086
  ink render $* --style $style --size ${size:-320x320} --quiet -o "$work/$style-$name.png"
}

# series NAME COMMON OPTIONS...: drawings beside each other, as Documentation/images/STYLE-NAME.png
series() {
  local name="$1" common="$2" parts=() one
  shift 2
  for one in "$@"; do
    picture "$name-${#parts[@]}" "$common" "$one"
    parts+=("$work/$style-$name-${#parts[@]}.png")
  done
  "$INK_PYTHON" Utilities/pictures.py join "$images/$style-$name.png" "${parts[@]}"
  echo "$images/$style-$name.png"
}

stipple_pictures() {
  local style=stipple
  local bonsai="Data/bonsai.nii.gz --view front --elevation 12 --percentile 97"
  local engine="Data/engine.nii.gz --stipple-source volume --view iso"
  local block="$work/engine.ply --view iso"
  local plain="--interior 0 --distance 0"
  series boundary "$bonsai $plain --silhouette off --pixels-per-stipple 12" "--boundary off" "--boundary 0.1,1.5,1"
  series silhouette "$engine $plain --lighting off --pixels-per-stipple 25" "--silhouette off" "--silhouette 0.3,3,0.3"
  series resolution "$block --lighting off --distance 0 --pixels-per-stipple 16" "--resolution off" "--resolution -2,1"
  series lighting "$block --distance 0" "--lighting off" "--lighting 1"
  series distance "$engine" "--distance 0" "--distance 0.5"
  series size "$engine" "--distance-curve 1,0 --interior-curve 0.3,0" "--distance-curve 1,1 --interior-curve 0.3,1"
  series interior "$bonsai" "--interior 0" "--interior 0.4"
  series color "$block" "" "--color 1"
  series occluder "Data/engine.nii.gz --view iso" "--stipple-source volume" "--iso 80"
  series parts "$engine --zoom 0.6" "--parts probability" "--parts intensity"
  series presets "$engine" "--preset anatomy" "--preset bone" "--preset soft-tissue" "--preset engineering" \
    "--preset plate-white-on-black"
  series published "$engine --max-stipples projected" "--preset anatomy" "--preset as-published" \
    "--preset as-published --stipple-size 2"
}

contours_pictures() {
  local style=contours
  series presets "Data/engine.nii.gz --iso 80 --view iso" "--preset pen" "--preset technical" "--preset hidden-lines" \
    "--preset glass" "--preset brush"
  series methods "Data/engine.nii.gz --iso 80 --view iso" "" "--method voxel-segments --line-width 1.5" \
    "--method image-space --line-width 4" "--method toon --largest-cosine 0.3"
  series hidden "Data/bonsai.nii.gz --iso 40 --elevation 12" "" "--hidden-lines faint" "--hidden-lines dashed"
  local size=200x200
  local engine="Data/engine.nii.gz --iso 80 --view iso"
  local bonsai="Data/bonsai.nii.gz --iso 40 --elevation 12"
  local edges="$work/edges.vtp --view front --azimuth 25 --elevation 25 --line-width 7"
  local near="$work/sheets.vtp --view front --azimuth 25 --elevation 25 --zoom 0.9 --depth-width 0 --line-width 60"
  series widths "$engine" "--line-width 1.5" "--line-width 6" "--line-width 6 --depth-width 0" "--line-width 6 --depth-width 1"
  series ends "$near" "" "--taper 0.8" "--cap butt" "--join miter"
  series density "$bonsai" "" "--density 0.9" "--density 0.5" "--density 0.2"
  series texture "$near --texture Data/pencil.png" "--texture-length 8" "--texture-length 2" "--texture-length 8 --taper 0.8"
  series colors "$engine --line-width 5" "--ink-color #993300 --paper-color #ffffcc" "--ink-color white --paper-color black"
  series kinds "$edges" "" "--no-silhouettes" "--no-creases" "--no-borders" "--non-manifold-edges" "--feature-angle 70"
  series faceted "$work/engine.ply --view iso --zoom 6 --no-creases --line-width 5" "" "--faceted"
  series creases "$work/engine.ply --view iso" "--no-creases" "--shortest-crease 0" "" "--feature-angle 80"
  "$INK_PYTHON" Utilities/pictures.py holes "$work/engine.ply" "$work/holes.vtp"
  series borders "$work/holes.vtp --view iso" "--shortest-border 0" ""
  series hidden-lines "$edges" "--hidden-opacity 0.2" "--hidden-opacity 0.7" "--dash-length 10 --gap-length 10" \
    "--dash-length 30 --gap-length 10" "--dash-length 10 --gap-length 30"
  series parts-of-lines "$bonsai --zoom 3" "--shortest-part 0" "" "--shortest-part 33"
  series iso "Data/bonsai.nii.gz --elevation 12" "--iso 25" "--iso 40" "--iso 150"
  series parts "$bonsai" "--smallest-part 0" "" "--largest-parts 1"
  series cut "Data/bonsai.nii.gz --iso 40 --elevation -30" "--cut rim" "--cut cap"
  series smoothing "$bonsai --zoom 2" "--smoothing 0" "" "--smoothing 4" "--smoothing 4 --smoothing-target surface"
  series subdivision "$bonsai --zoom 8 --smoothing 0" "--subdivision 1" "--subdivision 4"
  local voxels="$engine --method voxel-segments --line-width 2"
  series edge-voxels "$voxels" "--edge-scale 0" "" "--edge-scale 3" "--least-gradient 0.05" "--least-gradient 0.4" "--value-range 100,255"
  series segments "$voxels --zoom 2.5" "--segment-length 0.5" "--segment-length 3" "--largest-cosine 0.02" "--largest-cosine 0.3"
  series surface-methods "$engine" "--method toon" "--method toon --largest-cosine 0.4" "--method image-space --line-width 12 --zoom 0.4" \
    "--method image-space --line-width 12 --zoom 0.4 --no-thinning"
  size=320x320
  local parts=() one
  for style in stipple splatting-lines illustration; do
    for one in "" "--silhouettes"; do
      picture "silhouettes-${#parts[@]}" "Data/engine.nii.gz --iso 80 --view iso" "$one"
      parts+=("$work/$style-silhouettes-${#parts[@]}.png")
    done
  done
  "$INK_PYTHON" Utilities/pictures.py join "$images/contours-silhouettes.png" "${parts[@]}"
  echo "$images/contours-silhouettes.png"
}

line_art_pictures() {
  local style=line-art
  local engine="Data/engine.nii.gz --iso 80 --view iso"
  series tone "$engine" "--tone 0.3" "--tone 0.7" "--crosshatch 0" "--crosshatch 1"
  series presets "$engine" "--preset engraving" "--preset sketch" "--preset technical"
  local size=280x280
  series density "$engine" "--density 0.1" "--density 0.4" "--density 0.7"
  size=200x200
  local near="$engine --density 0.3"
  series length "$near" "" "--length 120 --taper 0.5" "--length 40 --taper 0.5" "--length 40"
  series width "$near --tone 0.4" "--width 1" "--width 0.5" "--width 0"
  series crosshatch "$near --tone 0.65" "--crosshatch 0" "--crosshatch 0.4" "--crosshatch 0.7" "--crosshatch 1"
  series contours "$near" "--contour-width 0" "" "--contour-width 8 --depth-width 0" "--contour-width 8 --depth-width 0.8"
  series light "$near" "" "--light 60,30" "--silhouette-weight 1" "--darkest-tone 0.5" "--diffuse-truncation 0.4"
  series curvature "$near" "" "--curvature mesh" "--no-smooth-directions"
  series seeding "$near" "" "--seeding scatter" "--seed 1"
  local edges="$work/edges.vtp --view front --azimuth 25 --elevation 25 --density 0 --line-spacing 14 --contour-width 8"
  series edges "$edges" "" "--no-silhouettes" "--no-borders" "--creases" "--creases --crease-angle 80"
  series colors "$near" "--ink-color #993300 --paper-color #ffffcc" "--ink-color white --paper-color black"
  size=320x320
  # Those of files that are not in Data: horse.ply, bunny.ply and cranium.nii.gz, in the folder INK_MESHES.
  if [ -f "${INK_MESHES:-}/horse.ply" ]; then
    local horse="$INK_MESHES/horse.ply --quiet"
    # shellcheck disable=SC2086
    ink render $horse --style line-art --size 800x700 -o "$work/horse.png"
    "$INK_PYTHON" Utilities/pictures.py join "$images/line-art-horse.png" "$work/horse.png"
    "$INK_PYTHON" Utilities/pictures.py scatter "$INK_MESHES/horse.ply" "$work/line-art-published-scatter.png"
    local plain="$horse --crosshatch 0" size=360x320
    picture published-1 "$plain --tone 1 --darkest-tone 0.3 --diffuse-truncation 0 --contour-width 0"
    picture published-2 "$plain"
    picture published-3 "$plain --density 0.3"
    "$INK_PYTHON" Utilities/pictures.py join "$images/line-art-published.png" "$work"/line-art-published-{1,2,3,scatter}.png
    echo "$images/line-art-published.png"
    "$INK_PYTHON" Utilities/pictures.py combing "$INK_MESHES/horse.ply" "$work"/line-art-combing-{0,1}.png
    "$INK_PYTHON" Utilities/pictures.py join "$images/line-art-combing.png" "$work"/line-art-combing-{0,1}.png
    echo "$images/line-art-combing.png"
    "$INK_PYTHON" Utilities/pictures.py prefixes "$INK_MESHES/horse.ply" "$work"/lines-of-curvature-{0,1,2}.png
    "$INK_PYTHON" Utilities/pictures.py join "$images/lines-of-curvature.png" "$work"/lines-of-curvature-{0,1,2}.png
    echo "$images/lines-of-curvature.png"
  fi
  if [ -f "${INK_MESHES:-}/cranium.nii.gz" ] && [ -f "$INK_MESHES/bunny.ply" ]; then
    size=280x280
    series subjects "--density 0.4" "$INK_MESHES/bunny.ply --up y" "$INK_MESHES/horse.ply" "Data/engine.nii.gz --iso 80 --view iso" \
      "$INK_MESHES/cranium.nii.gz --iso 300 --largest-parts 1"
    ink render "$INK_MESHES/cranium.nii.gz" --iso 300 --largest-parts 1 --tone 0.6 --style line-art --size 900x900 --quiet \
      -o "$work/skull.png"
    "$INK_PYTHON" Utilities/pictures.py join "$images/line-art-skull.png" "$work/skull.png"
    echo "$images/line-art-skull.png"
  fi
}

illustration_pictures() {
  ink render Data/engine.nii.gz --iso 80 --view iso --size 1000x800 -o "$images/illustration.png"
  echo "$images/illustration.png"
  local style=illustration
  "$INK_PYTHON" Utilities/pictures.py coarse "$work/coarse.vtp"
  series coarse "$work/coarse.vtp --up y --view iso" "--no-curved-meshes" ""
  "$INK_PYTHON" Utilities/pictures.py labels Data/engine.nii.gz 80 "$work/labels.vti"
  series labels "$work/labels.vti --view iso" "--label-borders off" ""
  series colors "$work/labels.vti --view iso" "--color-map rainbow"
  # Of a file that is not in Data.
  if [ -f "${INK_MESHES:-}/cranium.nii.gz" ]; then
    "$INK_PYTHON" Utilities/pictures.py slices "$INK_MESHES/cranium.nii.gz" 6 "$work/slices.vti"
    series slices "$work/slices.vti --iso -800" "--shape-based-interpolation off" ""
  fi
}

lines_pictures() {
  local style=splatting-lines
  local engine="Data/engine.nii.gz --iso 80 --view iso"
  local bonsai="Data/bonsai.nii.gz --iso 40 --view front --elevation 12"
  series tau "$bonsai" "--tau 0.96" "" "--tau 1.01"
  series phi "$engine" "--phi 10" "--phi 30" ""
  series lambda "$bonsai --zoom 1.5" "--lambda 1" "" "--lambda 10"
  series sigma "$engine" "--sigma 0.2" "" "--sigma 1"
  series published "$engine --zoom 1.5" "--as-published" ""
  series colors "$engine" "--ink-color white --paper-color black --background black" \
    "--ink-color #993300 --paper-color #ffffcc --background #ffffcc" "--paper-color none"
  series minimum-radius "$engine" "" "--minimum-radius 6" "--minimum-radius 12"
  series layers "$engine" "" "--layers 2" "--layers 8 --hidden-strength 0.5"
  series hidden "$engine --layers 2 --hidden-strength 1" "--hidden-dashes 12" "--hidden-width -2" \
    "--hidden-color #cc3300"
  series back-faces "$engine --layers 2" "" "--peel-back-faces"
  series width "$engine" "--line-width -2" "" "--line-width 5"
  series thin "$engine" "" "--thin" "--thin --line-width 5"
  series hardness "$engine --phi 10" "--hardness 0" "--hardness 0.6" "--hardness 1"
  series speckles "$bonsai --tau 0.995" "" "--speckles 5" "--speckles 20"
  series tone "$engine --line-width 3" "" "--tone-color #ff6600"
  series texel "$bonsai --lambda 8" "--maximum-downsampling 1" "--maximum-downsampling 2" "--maximum-downsampling 4"
  series fraction "$bonsai" "" "--point-fraction 0.3" "--point-fraction 0.05"
  series iso "Data/bonsai.nii.gz --view front --elevation 12" "--iso 25" "--iso 40" "--iso 150"
  series samples "$work/engine.ply --view iso" "--samples 20000" "--samples 100000" "--samples 1000000"
  local noise
  for noise in white blue; do
    ink sample "$work/engine.ply" "$work/$noise.vtp" --count 120000 --noise $noise --quiet
  done
  series noise "--view iso" "$work/white.vtp" "$work/blue.vtp"
}

strokes_pictures() {
  "$INK_PYTHON" Utilities/pictures.py strokes Data/pencil.png "$work/strokes.png"
  "$INK_PYTHON" Utilities/pictures.py join "$images/strokes.png" "$work/strokes.png"
  echo "$images/strokes.png"
}

# Each: the surface's mesh, its volume as it was drawn before, and as it is by default.
quality_pictures() {
  local style name file
  local before="--smoothing 0 --subdivision 1 --smallest-part 0"
  for name in knot vessels "two materials"; do
    file="$work/${name// /-}"
    "$INK_PYTHON" Utilities/pictures.py phantom "$name" 64 1 uint8 0.05 "$file.vti" "$file.vtp"
    for style in splatting-lines stipple; do
      series "quality-${name// /-}" "--up z --view front --azimuth 30 --elevation 15" "$file.vtp" "$file.vti $before" "$file.vti"
    done
  done
  "$INK_PYTHON" Utilities/pictures.py scan head_ct "$work/head.vti"
  style=splatting-lines
  series quality-head "$work/head.vti --azimuth 30" "$before" ""
  series quality-engine "Data/engine.nii.gz --view iso" "$before" ""
  series quality-bonsai "Data/bonsai.nii.gz --elevation 12" "$before" ""
}

case "${1:-all}" in
  contours) contours_pictures ;;
  line-art) line_art_pictures ;;
  stipple) stipple_pictures ;;
  illustration) illustration_pictures ;;
  splatting-lines) lines_pictures ;;
  strokes) strokes_pictures ;;
  quality) quality_pictures ;;
  all) contours_pictures && illustration_pictures && line_art_pictures && stipple_pictures && lines_pictures && strokes_pictures && quality_pictures ;;
  *) echo "pictures: found '$1', expected contours, illustration, line-art, stipple, splatting-lines, strokes or quality" >&2 && exit 2 ;;
esac
