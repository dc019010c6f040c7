# SPDX-License-Identifier: BSD-3-Clause
"""Processor time (all threads) of an illustration of a volume when its iso-value changes: what is made anew, and the picture of it.

    . Utilities/env.sh headless && LP_NUM_THREADS=0 VTK_SMP_MAX_THREADS=1 $INK_PYTHON Testing/Benchmarks/iso_slider.py FILE.nii.gz ISO [CHANGES]

As ParaView's representation asks for it, in 1024 x 768 pixels: as many stipples as the densest picture takes. The value alternates between
ISO and ISO + 20; the first picture, which compiles shaders, is left out of the medians.
"""

import statistics
import sys
import time

from vtkink import vtk, vtkInkStyle

SIZE = (1024, 768)


def main(file, value, changes):
    reader = vtk.vtkNIFTIImageReader()
    reader.SetFileName(file)
    reader.Update()
    style = vtkInkStyle.CreateStyle("illustration")
    style.InteractiveOn()
    # As the representation does, see UpdatePictureSize.
    style.SetPictureSize(SIZE[0])
    style.SetPictureHeight(SIZE[0])
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(*SIZE)
    renderer = vtk.vtkRenderer()
    renderer.AddActor(style.GetActor())
    renderer.AddLight(style.GetLight())
    window.AddRenderer(renderer)
    made, drawn = [], []
    for change in range(changes + 1):
        style.SetIsoValues([value + 20 * (change % 2)])
        start = time.process_time()
        style.Draw(reader.GetOutput())
        between = time.process_time()
        if change == 0:
            renderer.ResetCamera()
        renderer.ResetCameraClippingRange()
        window.Render()
        window.WaitForCompletion()
        made.append(between - start)
        drawn.append(time.process_time() - between)
    points, stipples = (style.GetPiece(piece).GetNumberOfPoints() for piece in (0, 2))
    print(
        f"{points} points, {stipples} stipples: made in {statistics.median(made[1:]):.2f} s, "
        f"drawn in {statistics.median(drawn[1:]):.2f} s"
    )


main(sys.argv[1], float(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 4)
