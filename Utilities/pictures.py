# SPDX-License-Identifier: BSD-3-Clause
"""What Utilities/pictures.sh needs beside ink: meshes, phantoms, and pictures beside each other in few bytes.

    pictures.py mesh VOLUME.nii.gz ISO_VALUE OUT.ply
    pictures.py coarse OUT.vtp
    pictures.py holes MESH.ply OUT.vtp
    pictures.py phantom SURFACE VOXELS SLICE_DISTANCE TYPE NOISE OUT.vti OUT.vtp
    pictures.py scan NAME OUT.vti
    pictures.py slices VOLUME.nii.gz STEP OUT.vti
    pictures.py labels VOLUME.nii.gz ISO_VALUE OUT.vti
    pictures.py scatter MESH.ply OUT.png
    pictures.py prefixes MESH.ply OUT.png OUT.png OUT.png
    pictures.py combing MESH.ply OUT.png OUT.png
    pictures.py texture OUT.png
    pictures.py edges OUT.vtp SHEETS.vtp
    pictures.py strokes TEXTURE.png OUT.png
    pictures.py join OUT.png PICTURE.png ...

The last two of a phantom are its volume and the surface's mesh; Testing/Benchmarks/phantom_surfaces.py and scan_phantoms.py have the
surfaces and scans.
"""

import importlib
import pathlib
import struct
import sys
import zlib

import numpy as np
from vtkink import numpy_support, vtk, vtkInkLineArtStyle, vtkInkLinesOfCurvature, vtkInkStrokeMapper

GAP = 8
GRAYS = 16
SHADES = 6  # of red, green and blue each


def mesh(volume, iso_value, out):
    reader, surface, writer = vtk.vtkNIFTIImageReader(), vtk.vtkFlyingEdges3D(), vtk.vtkPLYWriter()
    reader.SetFileName(volume)
    surface.SetInputConnection(reader.GetOutputPort())
    surface.SetValue(0, float(iso_value))
    writer.SetInputConnection(surface.GetOutputPort())
    writer.SetFileName(out)
    writer.Write()


def coarse(out):
    """A torus of 24 times 12 quadrangles, with normals."""
    source = vtk.vtkSuperquadricSource()
    source.ToroidalOn()
    source.SetThetaResolution(24)
    source.SetPhiResolution(12)
    source.Update()
    write(vtk.vtkXMLPolyDataWriter(), source.GetOutput(), out)


def holes(path, out):
    """As scans have them: one triangle in 100 is lacking."""
    reader, kept = vtk.vtkPLYReader(), vtk.vtkPolyData()
    reader.SetFileName(path)
    reader.Update()
    whole, polygons = reader.GetOutput(), vtk.vtkCellArray()
    corners = vtk.vtkIdList()
    for cell in np.flatnonzero(np.random.default_rng(1).random(whole.GetNumberOfCells()) > 0.01):
        whole.GetCellPoints(cell, corners)
        polygons.InsertNextCell(corners)
    kept.SetPoints(whole.GetPoints())
    kept.SetPolys(polygons)
    write(vtk.vtkXMLPolyDataWriter(), kept, out)


def phantoms_module(name="phantoms"):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Testing" / "Benchmarks"))
    return importlib.import_module(name)


def write(writer, data, path):
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.Write()


def phantom(name, voxels, slice_distance, dtype, noise, volume, surface):
    phantoms = phantoms_module()
    grid = phantoms.cube(int(voxels), int(slice_distance))
    surfaces = phantoms_module("phantom_surfaces").SURFACES[name](grid)
    write(vtk.vtkXMLImageDataWriter(), phantoms.image(phantoms.voxelize(surfaces, grid, dtype, float(noise))), volume)
    write(vtk.vtkXMLPolyDataWriter(), phantoms.mesh(surfaces[0]), surface)


def scan(name, volume):
    phantom = phantoms_module("scan_phantoms").SCANS[name]().phantom
    write(vtk.vtkXMLImageDataWriter(), phantoms_module().image(phantom), volume)


def read_nifti(path):
    reader = vtk.vtkNIFTIImageReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def slices(volume, step, out):
    """Each so many slices along z."""
    picking = vtk.vtkExtractVOI()
    picking.SetInputData(read_nifti(volume))
    picking.SetSampleRate(1, 1, int(step))
    picking.Update()
    write(vtk.vtkXMLImageDataWriter(), picking.GetOutput(), out)


def labels(volume, iso_value, out):
    """What is at or above the iso-value, in two regions along each axis."""
    image = read_nifti(volume)
    values = numpy_support.vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
    halves = np.indices(values.shape) * 2 // np.reshape(values.shape, (3, 1, 1, 1))
    regions = np.where(values >= float(iso_value), 1 + halves[0] + 2 * halves[1] + 4 * halves[2], 0).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(regions.ravel(), deep=True))
    write(vtk.vtkXMLImageDataWriter(), image, out)


def surface_of(path):
    """A mesh with normals that point out of it."""
    reader, normals = vtk.vtkPLYReader(), vtk.vtkPolyDataNormals()
    reader.SetFileName(path)
    normals.SetInputConnection(reader.GetOutputPort())
    normals.SplittingOff()
    normals.AutoOrientNormalsOn()
    normals.Update()
    return normals.GetOutput()


def draw_sideways(actor, out, size, light=None):
    """A mesh that stands with z up, from +x."""
    renderer, window, camera = vtk.vtkRenderer(), vtk.vtkRenderWindow(), vtk.vtkCamera()
    renderer.AddActor(actor)
    renderer.SetBackground(1, 1, 1)
    if light:
        renderer.AddLight(light)
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    renderer.SetActiveCamera(camera)
    camera.SetPosition(1, 0, 0)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(1.3)
    window.Render()
    grab, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    grab.SetInput(window)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(out)
    writer.Write()


def drawn_lines(lines, surface):
    mapper, actor = vtkInkStrokeMapper(), vtk.vtkActor()
    mapper.SetInputConnection(lines.GetOutputPort())
    mapper.SetSurfaceData(surface)
    mapper.SetLineWidth(2)
    actor.SetMapper(mapper)
    return mapper, actor


def scatter(path, out):
    """Lines of curvature as published: scattered by area, four times as densely where the surface is bent, all alike."""
    surface, lines = surface_of(path), vtkInkLinesOfCurvature()
    lines.SetInputData(surface)
    lines.SetSeedingToAreaScatter()
    lines.SetNumberOfSeeds(1500)
    lines.SetMaximumLength(0.05 * surface.GetLength())
    lines.SetCurvatureThreshold(30 / surface.GetLength())
    lines.SetCurvatureFactor(4)
    draw_sideways(drawn_lines(lines, surface)[1], out, (360, 320))


def prefixes(path, *out):
    """Lines of maximum curvature: a tenth of them, two fifths, and all."""
    surface, lines = surface_of(path), vtkInkLinesOfCurvature()
    lines.SetInputData(surface)
    lines.SetSpacing(0.006 * surface.GetLength())
    mapper, actor = drawn_lines(lines, surface)
    for density, name in zip((0.1, 0.4, 1), out):
        mapper.SetDensity(density)
        draw_sideways(actor, name, (300, 267))


def combing(path, *out):
    """Line art by the sign of curvatures, and combed."""
    surface = surface_of(path)
    for combed, name in zip((False, True), out):
        style = vtkInkLineArtStyle()
        style.GetLinesOfCurvature().SetCombDirections(combed)
        style.SetPictureSize(620)
        style.SetPictureHeight(640)
        style.Draw(surface)
        draw_sideways(style.GetActor(), name, (620, 640), style.GetLight())


def texture(out, width=256, height=32):
    """How much ink a pencil leaves: less at its sides, and where the paper has pits. The end goes on with the begin."""
    noise = np.fft.fft2(np.random.default_rng(1).standard_normal((height, width)))
    frequencies = np.hypot(*np.meshgrid(np.fft.fftfreq(width), np.fft.fftfreq(height)))
    pits = np.fft.ifft2(noise * np.exp(-2 * (np.pi * 1.3 * frequencies) ** 2)).real
    across = np.abs(2 * (np.arange(height)[:, None] + 0.5) / height - 1)
    ink = np.clip(0.75 + 0.35 * pits / pits.std() - 1.1 * across**4, 0, 1)
    image = vtk.vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk((255 * ink).round().astype("u1").ravel(), deep=True))
    write(vtk.vtkPNGWriter(), image, out)


def strokes(texture_file, out, size=150):
    """A stroke with two corners and a bow, drawn in several ways side by side, in pixels."""
    bow = np.linspace(np.pi, -0.6 * np.pi, 60)
    corners = [(16, 24), (46, 118), (70, 24)]
    points = np.array(corners + [(113 + 29 * np.cos(a), 78 + 46 * np.sin(a)) for a in bow])
    reader = vtk.vtkPNGReader()
    reader.SetFileName(texture_file)
    reader.Update()

    def dashes(mapper):
        mapper.DashedOn()
        mapper.SetDashLength(18)
        mapper.SetGapLength(14)
        mapper.SetLineWidth(6)

    def pencil(mapper):
        mapper.SetTexture(reader.GetOutput())
        mapper.SetTextureLength(8)

    ways = (
        lambda mapper: None,
        lambda mapper: (mapper.SetJoinToMiter(), mapper.SetCapToButt()),
        dashes,
        lambda mapper: mapper.SetTaper(0.9),
        lambda mapper: mapper.SetInputArrayToProcess(0, 0, 0, 0, "Swelling"),
        pencil,
    )
    window, picture, writer = vtk.vtkRenderWindow(), vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(size * len(ways), size)
    for i, way in enumerate(ways):
        data, lines, swelling = vtk.vtkPolyData(), vtk.vtkCellArray(), vtk.vtkFloatArray()
        data.SetPoints(vtk.vtkPoints())
        swelling.SetName("Swelling")
        lines.InsertNextCell(len(points))
        for x, y in points:
            lines.InsertCellPoint(data.GetPoints().InsertNextPoint(x, y, 0))
            swelling.InsertNextValue(0.2 + 1.2 * np.sin(0.06 * y) ** 2)
        data.SetLines(lines)
        data.GetPointData().AddArray(swelling)
        mapper, actor, renderer = vtkInkStrokeMapper(), vtk.vtkActor(), vtk.vtkRenderer()
        mapper.SetInputData(data)
        mapper.SetSizeUnitToPixels()
        mapper.SetLineWidth(10)
        way(mapper)
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
        renderer.SetBackground(1, 1, 1)
        renderer.SetViewport(i / len(ways), 0, (i + 1) / len(ways), 1)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(size / 2)
        camera.SetFocalPoint(size / 2, size / 2, 0)
        camera.SetPosition(size / 2, size / 2, 100)
        window.AddRenderer(renderer)
    picture.SetInput(window)
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(out)
    writer.Write()


def edges(out, sheets_alone):
    """All kinds of edges: a prism's creases, a tube's borders, three sheets that meet in one edge; and a ball."""
    prism, tube, ball = vtk.vtkCylinderSource(), vtk.vtkCylinderSource(), vtk.vtkSphereSource()
    prism.SetResolution(6)
    prism.SetCenter(-1.2, 0, 0)
    prism.SetRadius(0.6)
    tube.SetResolution(64)
    tube.CappingOff()
    ball.SetCenter(0, 1.2, 0)
    ball.SetRadius(0.6)
    ball.SetThetaResolution(64)
    ball.SetPhiResolution(32)
    points, sheets, fan = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    ends = [(0, 0)] + [(0.6 * np.cos(angle), 0.6 * np.sin(angle)) for angle in (0.3, 2.4, 4.5)]
    for x, z in ends:
        points.InsertNextPoint(-1.2 + x, 0.8, z)
        points.InsertNextPoint(-1.2 + x, 1.6, z)
    for sheet in (1, 2, 3):
        sheets.InsertNextCell(4)
        for point in (0, 1, 2 * sheet + 1, 2 * sheet):
            sheets.InsertCellPoint(point)
    fan.SetPoints(points)
    fan.SetPolys(sheets)
    write(vtk.vtkXMLPolyDataWriter(), fan, sheets_alone)
    together = vtk.vtkAppendPolyData()
    for source in (prism, tube, ball):
        source.Update()
        # Normals would split edges.
        source.GetOutput().GetPointData().Initialize()
        together.AddInputData(source.GetOutput())
    together.AddInputData(fan)
    together.Update()
    write(vtk.vtkXMLPolyDataWriter(), together.GetOutput(), out)


def read(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return numpy_support.vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def encode(image):
    """A PNG file with a palette: some grays, or a cube of colors where there are any."""
    height, width, _ = image.shape
    colorful = np.ptp(image.astype(int), axis=2).max() > 8
    if colorful:
        shades = (image.astype(int) * (SHADES - 1) + 127) // 255
        indices = (shades[..., 0] * SHADES + shades[..., 1]) * SHADES + shades[..., 2]
        palette = [[c * 255 // (SHADES - 1) for c in divmod_twice(i)] for i in range(SHADES**3)]
        bits, rows = 8, indices.astype(np.uint8)
    else:
        indices = (image[..., 0].astype(int) * (GRAYS - 1) + 127) // 255
        palette = [[i * 255 // (GRAYS - 1)] * 3 for i in range(GRAYS)]
        pairs = np.pad(indices, ((0, 0), (0, width % 2)))
        bits, rows = 4, (pairs[:, 0::2] * 16 + pairs[:, 1::2]).astype(np.uint8)
    data = b"".join(b"\0" + row.tobytes() for row in rows)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, bits, 3, 0, 0, 0))
        + chunk(b"PLTE", bytes(np.ravel(palette).astype(np.uint8)))
        + chunk(b"IDAT", zlib.compress(data, 9))
        + chunk(b"IEND", b"")
    )


def divmod_twice(index):
    return index // SHADES**2, index // SHADES % SHADES, index % SHADES


def join(out, *paths):
    images = [read(path) for path in paths]
    gap = np.full((images[0].shape[0], GAP, 3), 255, np.uint8)
    parts = [part for image in images for part in (image, gap)][:-1]
    with open(out, "wb") as file:
        file.write(encode(np.concatenate(parts, axis=1)))


if __name__ == "__main__":
    {"mesh": mesh, "coarse": coarse, "holes": holes, "phantom": phantom, "scan": scan, "slices": slices, "labels": labels, "scatter": scatter, "prefixes": prefixes, "combing": combing,
     "texture": texture, "edges": edges, "strokes": strokes, "join": join}[sys.argv[1]](*sys.argv[2:])
