#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Draws Data/engine.nii.gz, a CT of an engine, with the headless build and prints where the pictures are.
set -euo pipefail

cd "$(dirname "$0")/.."
. Utilities/env.sh headless

pictures="build/demo"
mkdir -p "$pictures"
echo "demo: drawing an engine from three sides"
for view in iso front top; do
  ink render Data/engine.nii.gz --view "$view" --size 1200x900 -o "$pictures/engine-$view.png"
  echo "$INK_ROOT/$pictures/engine-$view.png"
done
echo "demo: in a shell, '. Utilities/env.sh headless' says where ink is; then: ink render FILE"
