#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Draws the pictures of ParaView's window in Documentation, of all representations or of one, with the paraview build:
#   Utilities/window-pictures.sh [Illustration|Stipple|Contours|"Line Art"]
# It needs what Utilities/setup.sh installs for paraview and window-pictures. The positions of the mouse are those in the window of ParaView 5.11.
set -euo pipefail

size=1280x960
# A display of its own, in which there is only that window.
if [ -z "${INK_WINDOW_PICTURES:-}" ]; then
  INK_WINDOW_PICTURES=1 exec xvfb-run -a -s "-noreset -screen 0 ${size}x24" "$0" "$@"
fi

cd "$(dirname "$0")/.."
. Utilities/env.sh paraview

images="$PWD/Documentation/images"
work="$PWD/build/pictures"
mkdir -p "$work"

# Until the application has drawn, and uses less than a tenth of a processor.
settle() {
  local before now=0
  while before="$now"; sleep 3; now="$(awk '{ print $14 + $15 }' "/proc/$application/stat")"; ((now - before > 30)); do :; done
}

drag() {
  xdotool mousemove "$1" "$2" mousedown 1 mousemove "$3" "$4" sleep 0.5 mousemove "$3" "$4" mouseup 1
  settle
}

# picture REPRESENTATION PICTURE SCROLL [SCRIPT]: the engine; SCROLL, how many clicks of the wheel the panel is scrolled,
# and what else SCRIPT sets of the display and view
picture() {
  local script="$work/window.py" ready="$work/ready" application
  rm -f "$ready"
  cat >"$script" <<EOF
from paraview.simple import *
source = OpenDataFile("$PWD/Data/engine.nii.gz")
RenameSource("engine.nii.gz", source)
display = Show(source)
display.SetRepresentationType("$1")
view = GetActiveView()
view.OrientationAxesVisibility = 0
view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [0, 0, 0], [1, -1, 1], [-1, 1, 2]
${4:-}
ResetCamera()
Render()
open("$ready", "w")
EOF
  paraview --dr --script="$script" >"$work/window.log" 2>&1 &
  application=$!
  until [ -f "$ready" ]; do
    kill -0 "$application" || { cat "$work/window.log" >&2 && exit 1; }
    sleep 1
  done
  settle
  xdotool search --sync --name 'ParaView [0-9]' windowsize "${size%x*}" "${size#*x}"
  settle
  drag 295 538 445 538                                         # a panel as wide as its contents,
  drag 147 421 147 250                                         # and as high as there is room for
  xdotool mousemove 225 880 click --repeat "$3" --delay 200 5  # on a label: the wheel would move a slider
  settle
  import -window root -crop "$size+0+0" +repage "$work/window.png"
  kill "$application"
  wait "$application" || true
  convert "$work/window.png" -strip +dither -colors 96 "PNG8:$images/$2.png"
  echo "Documentation/images/$2.png"
}

illustration() { picture Illustration paraview-window 4; }
stipple() {
  picture Stipple paraview-stipple 4 "view.CameraPosition, view.CameraViewUp = [-0.6, 0.5, 1], [0, 1, 0]"
}
contours() { picture Contours paraview-contours 4 "display.ContoursPreset = 'Hidden Lines'"; }
line_art() { picture "Line Art" paraview-line-art 4; }

case "${1:-all}" in
  Illustration) illustration ;;
  Stipple) stipple ;;
  Contours) contours ;;
  "Line Art") line_art ;;
  all) illustration && stipple && contours && line_art ;;
  *) echo "window-pictures: found '$1', expected Illustration, Stipple, Contours or Line Art" >&2 && exit 2 ;;
esac
