# SPDX-License-Identifier: BSD-3-Clause
"""Draws a volume or a mesh like an engraving to line_art.png:  line_art.py [FILE [ISO_VALUE [PRESET]]]"""
import sys
import vtkink

file = sys.argv[1] if len(sys.argv) > 1 else sys.path[0] + "/../../Data/engine.nii.gz"
iso_values = [float(value) for value in sys.argv[2:3]]
preset = sys.argv[3] if len(sys.argv) > 3 else "engraving"
actor = vtkink.draw(file, "line-art", "line_art.png", view="iso", preset=preset, iso_values=iso_values)
for note in range(actor.style.GetNumberOfNotes()):
    print(actor.style.GetNote(note))
