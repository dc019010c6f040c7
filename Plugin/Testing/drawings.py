# SPDX-License-Identifier: BSD-3-Clause
"""Draws pictures of every way that data comes in parts, for TestParallel.py to compare, and saves its points:

pvbatch drawings.py INPUT_FOLDER OUTPUT_FOLDER [PICTURE]...

With names of pictures no others. What is drawn again keeps what was set before, so pictures that follow others of theirs
are the same only after these."""

import pathlib
import sys

from rendering import *

INPUT, OUTPUT = sys.argv[1:3]
CHOSEN = sys.argv[3:]


def save_points(name, proxy):
    """All points of all processes, sorted, with what belongs to them."""
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy)
    if data.IsA("vtkCompositeDataSet"):
        append = vtk.vtkAppendPolyData()
        leaves = data.NewIterator()
        while not leaves.IsDoneWithTraversal():
            append.AddInputData(leaves.GetCurrentDataObject())
            leaves.GoToNextItem()
        append.Update()
        data = append.GetOutput()
    columns = [vtk_to_numpy(data.GetPoints().GetData())]
    for array in ("Normals", "Radius", "Priority"):
        if data.GetPointData().HasArray(array):
            columns.append(vtk_to_numpy(data.GetPointData().GetArray(array)).reshape(len(columns[0]), -1))
    rows = numpy.hstack(columns)
    numpy.save(f"{OUTPUT}/{name}.npy", rows[numpy.lexsort(rows.T)])


def draw(name, source, style, zoom=1, **properties):
    if CHOSEN and name not in CHOSEN:
        return
    display = Show(source, view)
    display.SetRepresentationType(style)
    display.ColorArrayName = ["POINTS", ""]
    if style == "Stipple":
        # Dots of some pixels in small pictures, too.
        display.SizeUnit = "Pixels"
    for key, value in properties.items():
        setattr(display, key, value)
    # Without the picture that simple.py's draws.
    view.ResetCamera()
    view.CameraViewAngle /= zoom
    SaveScreenshot(f"{OUTPUT}/{name}.png", view)
    view.CameraViewAngle *= zoom
    Hide(source, view)


wavelet = Wavelet(WholeExtent=[-16, 14, -13, 15, -12, 14])
wavelet.UpdatePipeline()
view = green_view(120)

# Beside a neighbor that each process has a part of, half in front of the drawing.
ball = Sphere(Radius=4, Center=[5, 0, 8], ThetaResolution=32, PhiResolution=32)
Show(ball, view)
draw("paper", InkIsoSurfaceSampler(Input=wavelet, Isosurfaces=[150.0]), "Splatting Lines", Phi=100)
Hide(ball, view)

# Nothing at all, of which ParaView finds no order: several processes would abort.
SetActiveSource(wavelet)
nothing = InkIsoSurfaceSampler(Input=wavelet, Isosurfaces=[1e6])
for style in ("Splatting Lines", "Stipple"):
    Show(nothing, view).SetRepresentationType(style)
    Render(view)
Hide(nothing, view)

volumes = {name: OpenDataFile(f"{INPUT}/volume.{name}") for name in ("nii", "vtk", "vti", "pvti", "mhd")}
volumes["raw"] = ImageReader(
    FileNames=[f"{INPUT}/volume.raw"],
    DataScalarType="float",
    DataByteOrder="LittleEndian",
    DataExtent=[0, 30, 0, 28, 0, 26],
)
volumes["wavelet"] = wavelet
vdb = pathlib.Path(f"{INPUT}/volume.vdb")
if vdb.exists():
    volumes["vdb"] = InkOpenVDBReader(FileName=str(vdb))
    save_points("vdb-straight", InkOpenVDBIsoSurfaceSampler(FileName=str(vdb), Isosurfaces=[150.0]))
for name, volume in volumes.items():
    volume.UpdatePipeline()
    # A new filter's array is at first one of the active source's.
    SetActiveSource(volume)
    save_points(f"{name}-sampler", InkIsoSurfaceSampler(Input=volume, Isosurfaces=[150.0]))
    SetActiveSource(volume)
    save_points(f"{name}-generator", InkStippleGenerator(Input=volume, GradientPercentile=90))

# One that splits itself, one that is on the first process alone, and one of files of parts.
for name in ("wavelet", "nii", "pvti"):
    volume = volumes[name]
    SetActiveSource(volume)
    sampler = InkIsoSurfaceSampler(Input=InkGradient(Input=volume), Isosurfaces=[150.0])
    save_points(f"{name}-gradient", sampler)
    draw(f"{name}-lines", sampler, "Splatting Lines", Phi=100, PaperVisibility=False)
    draw(f"{name}-stipples", volume, "Stipple", GradientPercentile=70)
# As many in a voxel as it has pixels in a picture of the whole: 31 of them along the longest side.
projected = {"MaximumStipplesMode": "Projected", "GradientPercentile": 90}
for name in ("wavelet", "nii", "pvti"):
    SetActiveSource(volumes[name])
    save_points(f"{name}-projected", InkStippleGenerator(Input=volumes[name], PictureSize=125, **projected))
draw("projected-stipples", wavelet, "Stipple", StipplePictureSize=125, **projected)
draw("solid-stipples", wavelet, "Stipple", StippleIsoValue=150.0, StippleSource="Iso-Surface")
# All of what is automatic.
for name in ("wavelet", "nii", "pvti"):
    draw(f"{name}-solid-illustration", volumes[name], "Illustration")
    draw(f"{name}-contours", volumes[name], "Contours", ContoursLineWidth=10)
# As many marks as small pictures take: what is automatic makes them for large ones, too.
FEW = {"IllustrationNumberOfSurfaceStipples": 20000, "IllustrationNumberOfSamples": 100000}
# Borders of labels, and their colors.
labels = Calculator(Input=volumes["pvti"], ResultArrayName="Labels", Function="floor(RTData/60)")
draw("pvti-labels-solid-illustration", labels, "Illustration", IllustrationAutomaticIsoValue=0, IllustrationIsoValue=1.5,
    IllustrationLabelMap="On", IllustrationLabelBorders="On", ColorArrayName=["POINTS", "Labels"], **FEW)
# Thick slices, between which contours are interpolated.
thick = OpenDataFile(f"{INPUT}/slices.pvti")
thick.UpdatePipeline()
SetActiveSource(thick)
save_points("slices-sampler", InkIsoSurfaceSampler(Input=thick, Isosurfaces=[150.0], Smoothing=1, ShapeBasedInterpolation=1))
draw("slices-solid-illustration", thick, "Illustration", IllustrationShapeBasedInterpolation="On")
# What was enlarged is drawn as what it was made of.
enlarged = OpenDataFile(f"{INPUT}/enlarged.pvti")
draw("enlarged-solid-illustration", enlarged, "Illustration", **FEW)
draw("enlarged-blocks-solid-illustration", enlarged, "Illustration", IllustrationLabelMap="Off", **FEW)
draw("outlined-solid-illustration", wavelet, "Illustration", IllustrationSilhouettes=1, **FEW)
draw("outlined-lines", wavelet, "Splatting Lines", Phi=100, LinesSilhouettes=1)
draw("see-through-solid-illustration", wavelet, "Illustration", IllustrationSeeThrough=1, IllustrationAutomaticIsoValue=0,
    IllustrationIsoValue=200.0, IllustrationAutomaticOuterIsoValue=0, IllustrationOuterIsoValue=120.0, **FEW)
draw("image-lines", volumes["nii"], "Splatting Lines", Phi=100)
# As fine as it is seen: from a quarter of the size on, in this view, to that of a view of all.
draw("image-zoomed-lines", volumes["pvti"], "Splatting Lines", zoom=4, Phi=100)
draw("image-zoomed-solid-illustration", volumes["nii"], "Illustration", zoom=4)

meshes = {name: OpenDataFile(f"{INPUT}/mesh.{name}") for name in ("vtk", "ply", "vtp", "pvtp")}
meshes["sphere"] = ball
meshes["contour"] = Contour(Input=wavelet, Isosurfaces=[150.0])
meshes["contour-of-file"] = Contour(Input=volumes["nii"], Isosurfaces=[150.0])
meshes["blocks"] = GroupDatasets(Input=[meshes["vtk"], meshes["ply"]])
for name, mesh in meshes.items():
    mesh.UpdatePipeline()
    SetActiveSource(mesh)
    save_points(f"{name}-samples", InkSurfaceSampler(Input=mesh, NumberOfSamples=2000))
for name in ("sphere", "contour"):
    SetActiveSource(meshes[name])
    save_points(f"{name}-generator", InkStippleGenerator(Input=meshes[name], NumberOfSurfaceStipples=2000))
for name in ("pvtp", "contour-of-file"):
    draw(f"{name}-solid-illustration", meshes[name], "Illustration", **FEW)
for name in ("pvtp", "sphere", "contour", "blocks"):
    draw(f"{name}-contours", meshes[name], "Contours", ContoursLineWidth=10, ContoursHiddenLines="Dashed")
draw("pvti-line-art", volumes["pvti"], "Line Art", LineArtDensity=0, LineArtLineSpacing=16, LineArtSubdivision=1)
draw("pvtp-line-art", meshes["pvtp"], "Line Art", LineArtDensity=0, LineArtLineSpacing=16)
draw("outlined-stipples", meshes["contour"], "Stipple", NumberOfSurfaceStipples=5000, StippleSilhouettes=1)
for name in ("ply", "pvtp", "sphere", "contour", "contour-of-file"):
    draw(f"{name}-stipples", meshes[name], "Stipple", NumberOfSurfaceStipples=5000)

# Drawn by its own points, each process's by itself; the others are sampled, or get their normals, on the first process.
draw("dense-lines", Sphere(Radius=4, ThetaResolution=500, PhiResolution=250), "Splatting Lines", Phi=100)
for name in ("sphere", "pvtp", "blocks"):
    draw(f"{name}-lines", meshes[name], "Splatting Lines", Phi=100, LinesNumberOfSamples=20000)
draw("cloud-lines", PointSource(NumberOfPoints=2000, Radius=4), "Splatting Lines", Phi=100)
# The largest part of six, and those of half its size, of which there are two: they reach over processes' borders.
parts = Calculator(Input=wavelet, ResultArrayName="Parts", Function="sin(coordsX/4)*sin(coordsY/4)*cos(coordsZ/8)+coordsX/60")
for name, properties in (("largest", {"LargestParts": 1}), ("larger", {"SmallestPart": 0.5})):
    for style, prefix, others in (
        ("Splatting Lines", "Lines", {"Phi": 100}),
        ("Illustration", "Illustration", FEW),
        ("Contours", "Contours", {"ContoursLineWidth": 10}),
    ):
        of_parts = {"AutomaticIsoValue": 0, "IsoValue": 0.4, **properties}
        draw(f"{name}-parts-solid-{style.split()[-1].lower()}", parts, style, **others,
            **{prefix + key: value for key, value in of_parts.items()})

# Which stipples are drawn by chance goes by what elements are, wherever they are.
for name, source in (("volume", wavelet), ("mesh", meshes["sphere"])):
    draw(f"{name}-chance-stipples", source, "Stipple", GradientPercentile=70, NumberOfSurfaceStipples=5000,
        SmallElements="Whole Ones by Chance")
