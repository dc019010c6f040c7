# SPDX-License-Identifier: BSD-3-Clause
# Labels by subject, so that `ctest -L sampling` runs the tests of one: a label for each row whose pattern is found in the
# test's name. Read where tests are added, and once more by ctest, which finds the tests of GoogleTest in their programs.
# The test TestLabels fails where a test has no label.
set(_ink_test_labels
  "curvature:Curvature|SurfaceRings|JetFit|ExponentialMap"
  "fields:UnitOrZero|ActiveScalars|CellCenters|ImageOfGrid|Subsample|AnalyticFields|AxisResampling|Projection|Grid(Field|Geometry)|Gradient|Crop|Laplacian|NormalMethods|ResampleGrid|SampleBox|SliceDistances|VdbField"
  "sampling:PoissonDisk|BlueNoise|WhiteNoise|IsoSurface|Sampl(er|es|ing)|SampleRadius|ActiveCell(Bound|Components|Extent)|CutSamples|LabelBorders|IsoThreshold|MinMaxBricks|Point(Normals|Output|Radii|Spacing|Clouds|Priority)"
  "sampling:KdTree|CoincidentPoints|ImageSlabs|MemoryBudget|DiscSamples|SampleGroups|ProgressiveOrder|SurfaceStretch|GeodesicUnfolding|MeshOrder|FeatureNormals"
  "stippling:Stippl|QuantizedPosition"
  "tone:Tone|Hatching|LocalSpacing|AreaSamples|DotCoverage|HlsColor|SmallElements|WarmCool"
  "lines:SplattingLines"
  "strokes:Stroke|CurveVisibility"
  "streamlines:Streamline|LineSampleGrid|CrossField|AlignedLineField|CombDirections|PointGroups|SolidMesh|LongestBorder|BorderEdges|WeldedTriangles|SeenTriangles|TrianglesWithin|FlatDirections|FormDirections|CurvedMesh|FeatureSplit|InsideOut|MeshNavigation|RepeatedTriangles|LinesOfCurvature"
  "contours:Contours|EdgeOffsets|GridBorder|ChainSegments|CoherentDashes|ClusterPlanes|LargePages|NormalClusters|Silhouette(Voxels|s)|VoxelSegments"
  "raster:CommonTests.(Dash|Despeckle|Dilate|Thin|Trace)"
  "statistics:IsoValue|IsoBoundaries|OtsuThreshold|IsoStatistics|MaterialValues|NoiseEstimate|Histogram|FiniteRange|KeepRange|CoveredSides|FilledBox|SliceCounter|SmoothedSlices|RepeatedSamples|InterpolatedSlices|Periodogram"
  "vdb:Vdb|VDB|vdb"
  "reading:DidYouMean|FormatNumber|FuzzCorpus|^IO(Core|Mesh|Volume)"
  "styles:^Styles"
  "rendering:^(RenderingCore|SplattingLines|Stipple|Strokes)Tests|^RenderingCore|^Shaders|Mapper"
  "parallel:Parallel(Chunks|For)|Threads|Pieces|Plugin.TestParallel"
  "stability:^StabilityTests"
  "plugin:^Plugin"
  "project:OutsideProject|TestLabels")

function (ink_label_test test)
  set(labels "")
  foreach (row IN LISTS _ink_test_labels)
    string(REGEX MATCH "^[a-z]+" label "${row}")
    string(REGEX REPLACE "^[a-z]+:" "" pattern "${row}")
    if (test MATCHES "${pattern}")
      list(APPEND labels "${label}")
    endif ()
  endforeach ()
  set_tests_properties("${test}" PROPERTIES LABELS "${labels}")
endfunction ()
