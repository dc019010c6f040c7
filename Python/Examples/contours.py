# SPDX-License-Identifier: BSD-3-Clause
"""Draws the contours of a volume or a mesh to contours.png, hidden lines dashed:  contours.py [FILE [ISO_VALUE]]"""
import sys
import vtkink

file = sys.argv[1] if len(sys.argv) > 1 else sys.path[0] + "/../../Data/engine.nii.gz"
iso_values = [float(value) for value in sys.argv[2:3]]
actor = vtkink.draw(file, "contours", "contours.png", view="iso", preset="hidden-lines", iso_values=iso_values)
for note in range(actor.style.GetNumberOfNotes()):
    print(actor.style.GetNote(note))
