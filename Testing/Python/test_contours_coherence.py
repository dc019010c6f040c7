# SPDX-License-Identifier: BSD-3-Clause
"""What the coherence of contours is measured with tells what appears, what disappears, and how far dashes slide."""

import pytest

pytestmark = pytest.mark.one_build

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
import contours_coherence as coherence  # noqa: E402

PERIOD = 0.1


def frame(*spans):
    """Lines along x, each at its height, from a begin to an end, of steps of 0.005."""
    append = vtk.vtkAppendPolyData()
    for height, begin, end in spans:
        line, arcs = vtk.vtkLineSource(), vtk.vtkDoubleArray()
        line.SetPoint1(begin, height, 0)
        line.SetPoint2(end, height, 0)
        line.SetResolution(round((end - begin) / 0.005))
        line.Update()
        arcs.SetName("ArcLength")
        for i in range(line.GetOutput().GetNumberOfPoints()):
            arcs.InsertNextValue(line.GetOutput().GetPoint(i)[0] - begin)
        line.GetOutput().GetPointData().AddArray(arcs)
        append.AddInputData(line.GetOutput())
    append.Update()
    return coherence.Frame(append.GetOutput(), PERIOD)


def test_what_stays_neither_appears_nor_slides():
    still = frame((0, 0, 1), (1, 0, 2))
    assert coherence.compare(still, still, 0.03) == pytest.approx((0, 0, 0, 0), abs=1e-9)


def test_lines_that_come_and_go_count_by_their_length():
    before, after = frame((0, 0, 3), (1, 0, 1)), frame((0, 0, 3), (2, 0, 2))
    appear, disappear, slide, jump = coherence.compare(before, after, 0.03)
    assert (appear, disappear) == pytest.approx((2 / 5, 1 / 4), abs=1e-6)
    assert (slide, jump) == pytest.approx((0, 0), abs=1e-6)


@pytest.mark.parametrize("shift, slide, jump", [(0.0, 0, 0), (0.005, 0.05, 0), (0.03, 0.3, 1), (0.1, 0, 0)])
def test_dashes_slide_with_the_begin_of_their_line(shift, slide, jump):
    """A line that begins later has its dashes later; by a whole period it does not show."""
    before, after = frame((0, 0, 4)), frame((0, shift, 4))
    found = coherence.compare(before, after, 0.03)
    assert found[2:] == pytest.approx((slide, jump), abs=0.03)
    assert found[0] == 0


def test_edges_of_a_box_stay_where_they_are():
    assert coherence.measure(coherence.box(), 2, silhouettes=False) == pytest.approx((0, 0, 0, 0), abs=1e-9)
