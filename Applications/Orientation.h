#pragma once

#include <filesystem>

class vtkImageData;
class vtkNIFTIImageReader;

namespace ink::cli
{

/// Where the voxels of a volume lie: what medical files say about it, turned to DICOM's axes (+x to the left
/// of the patient, +y to the back, +z to the head).
struct Orientation
{
  double direction[3][3]; ///< direction[i] is the unit vector along which voxel index i grows
  double origin[3];       ///< of the first voxel

  /// Sets origin and direction of image. Does nothing if the directions are not at right angles, as those of
  /// sheared volumes: VTK's images cannot have such.
  /// \return whether it was set
  bool apply(vtkImageData* image) const;
};

/// The orientation that a NIfTI reader found (its sform, else its qform), if there is one.
/// \return whether there was one that could be used
bool applyNiftiOrientation(vtkNIFTIImageReader* reader, vtkImageData* image);

/// The orientation in a NRRD ("space directions") or MetaImage ("TransformMatrix") header, if there is one.
/// Spacing and origin are set as well.
/// \return false if there is one that cannot be used
bool applyNrrdOrientation(const std::filesystem::path& file, vtkImageData* image);
bool applyMetaImageOrientation(const std::filesystem::path& file, vtkImageData* image);

} // namespace ink::cli
