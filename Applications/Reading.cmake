# InkReading: what reads and checks the files that ink is given, a library of its own so that fuzzers run the same code.

# Whether the expat that VTK uses has a switch which XmlReaders.h needs.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_LIBRARIES VTK::expat VTK::IOXMLParser)
check_cxx_source_compiles("
  #include \"vtk_expat.h\"
  int main() { return XML_SetReparseDeferralEnabled(nullptr, XML_FALSE); }" INK_EXPAT_DEFERS)
unset(CMAKE_REQUIRED_LIBRARIES)

set(_ink_reading_sources
  CheckXmlFile.cxx
  Descriptor.cxx
  DicomFile.cxx
  FinishVolume.cxx
  Inflater.cxx
  Memory.cxx
  Orientation.cxx
  PlainVoxels.cxx
  PlyHeader.cxx
  Progress.cxx
  ReadDicomFolder.cxx
  ReadFile.cxx
  ReadLegacy.cxx
  ReadMesh.cxx
  ReadMetaImage.cxx
  ReadNifti.cxx
  ReadNrrd.cxx
  ReadObj.cxx
  ReadPly.cxx
  ReadPoints.cxx
  ReadRawVolume.cxx
  ReadStl.cxx
  ReadVolume.cxx
  TextHeader.cxx
  VolumeHeader.cxx
  VolumeSlices.cxx
  VoxelBytes.cxx
  VtkMessages.cxx
  Words.cxx)
list(TRANSFORM _ink_reading_sources PREPEND "${CMAKE_CURRENT_LIST_DIR}/")
add_library(InkReading STATIC ${_ink_reading_sources})
target_include_directories(InkReading PUBLIC "${CMAKE_CURRENT_LIST_DIR}")
target_link_libraries(InkReading PUBLIC
  VTK::CommonCore
  VTK::CommonDataModel
  VTK::CommonExecutionModel
  VTK::CommonMath
  VTK::IOXML
  VTK::IOXMLParser
  VTK::ImagingCore
  VTK::zlib)
if (INK_EXPAT_DEFERS)
  target_link_libraries(InkReading PRIVATE VTK::expat)
  target_compile_definitions(InkReading PRIVATE INK_EXPAT_DEFERS)
endif ()
ink_compile_options(InkReading)
