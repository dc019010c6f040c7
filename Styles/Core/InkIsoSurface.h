// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkIsoSurface_h
#define InkIsoSurface_h

#include "InkIsoValues.h"
#include "InkStyleProcesses.h"
#include "vtkInkStyle.h"
#include "vtkInkStylesModule.h" // for the export macro

#include "IsoSurface/ActiveCellComponents.h"
#include "Statistics/IsoValue.h"
#include "Statistics/NoiseEstimate.h"

#include "vtkNew.h"
#include "vtkTimeStamp.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkInkIsoSurfaceAlgorithm;
class vtkInkIsoSurfaceSampler;
class vtkPolyData;
struct InkSubdivision;

/// What styles that draw the iso-surfaces of images have in common: the points of these surfaces, at values
/// that are given or chosen. Images are InkLeaves' of its Scalars, which are active in them.
class VTKINKSTYLES_EXPORT InkIsoSurface
{
public:
  InkIsoSurface();
  ~InkIsoSurface();
  InkIsoSurface(const InkIsoSurface&) = delete;
  void operator=(const InkIsoSurface&) = delete;

  ///@{
  /// Parameters; see their table.
  void SetScalars(const std::string& array);
  const std::string& GetScalars() const { return this->Scalars; }
  void SetIsoValues(const std::vector<double>& values);
  const std::vector<double>& GetIsoValues() const { return this->IsoValues.GetGiven(); }
  /// Which surface is drawn where no iso-value is given.
  enum IsoChoiceType
  {
    OUTERMOST = 0, ///< ink::suggestIsoValues' first
    INNER = 1      ///< the clearest boundary within that, if there is one
  };
  void SetIsoChoice(int choice);
  int GetIsoChoice() const { return this->IsoChoice; }
  void SetSmallestPart(double share);
  double GetSmallestPart() const;
  void SetLargestParts(int count);
  int GetLargestParts() const;
  /// What is where a surface leaves the image: one of vtkInkIsoSurfaceAlgorithm's, or a cap of labels, whose
  /// regions are solid, and of slabs, of which hardly more than two cuts would be left, and a rim of all
  /// else, as it may show what lies within, and where the image surrounds what is to be seen, see
  /// ink::surroundsObject.
  static constexpr int CUT_AUTOMATIC = 3;
  void SetCut(int cut);
  int GetCut() const { return this->Cut; }
  void SetSmoothing(double smoothing);
  double GetSmoothing() const { return this->Smoothing; }
  /// How values are taken.
  enum LabelMapType
  {
    LABELS_AUTOMATIC = 0, ///< as labels where they seem to be labels, see ink::areLabels
    LABELS_OFF = 1,
    LABELS_ON = 2
  };
  void SetLabelMap(int labelMap);
  int GetLabelMap() const { return this->LabelMap; }
  /// Whether labels that meet have a groove between them.
  enum LabelBordersType
  {
    BORDERS_AUTOMATIC = 0, ///< where they are clear, see ink::SuggestedSmoothing
    BORDERS_OFF = 1,
    BORDERS_ON = 2
  };
  void SetLabelBorders(int borders);
  int GetLabelBorders() const { return this->LabelBorders; }
  /// What is smoothed: one of vtkInkIsoSurfaceAlgorithm's, or the surface of labels that are thick enough, as
  /// its steps show in outlines, and of all else normals.
  static constexpr int TARGET_AUTOMATIC = 2;
  void SetSmoothingTarget(int target);
  int GetSmoothingTarget() const { return this->SmoothingTarget; }
  /// Whether distances from contours are interpolated between slices.
  enum ShapeBasedInterpolationType
  {
    SHAPES_AUTOMATIC = 0, ///< where they are the better guess, see ink::suggestShapeBasedInterpolation
    SHAPES_OFF = 1,
    SHAPES_ON = 2
  };
  void SetShapeBasedInterpolation(int shapeBased);
  int GetShapeBasedInterpolation() const { return this->ShapeBasedInterpolation; }
  void SetSubdivision(int subdivision);
  int GetSubdivision() const { return this->Subdivision; }
  ///@}

  vtkInkIsoSurfaceSampler* GetSampler() { return this->Sampler; }

  ///@{
  /// Whether meshes have the curvature of the image's level sets, as arrays of vtkInkPrincipalCurvature.
  void SetComputeCurvature(bool compute);
  bool GetComputeCurvature() const { return this->ComputeCurvature; }
  ///@}

  /// The values that were prepared last, given or chosen.
  const std::vector<double>& GetUsedIsoValues() const { return this->IsoValues.GetUsed(); }

  /// When something changed last that the points depend on.
  /// @param ofValues whether iso-values are among it
  vtkMTimeType GetMTime(bool ofValues = true);

  /// All of another one's parameters but its iso-values.
  void CopyParameters(const InkIsoSurface& other);

  /**
   * The iso-values that suit the images of all processes, the best first; all processes call it at once, also
   * without images.
   */
  static std::vector<ink::IsoSuggestion> Suggest(vtkInkStyle* style, std::span<vtkImageData* const> images);

  /**
   * Finds what the images of all processes are sampled with; all processes call it at once, also without
   * images.
   * @param style that notes a value that is chosen
   * @return what is wrong; empty if nothing is
   */
  std::string Prepare(vtkInkStyle* style, std::span<vtkImageData* const> images);

  /**
   * The smoothing of images that are drawn without a surface: what is given, or what the value asks for that
   * suits best; all processes call it at once.
   */
  double ChooseSmoothing(vtkInkStyle* style, std::span<vtkImageData* const> images) const;

  /**
   * The points of an image's surfaces, with Normals and Radius; after Prepare.
   * @param style that follows the sampler
   * @param image to sample; of one that is input.Data, and comes from a port, the piece that is asked for
   * @param points becomes them
   * @return what is wrong; empty if nothing is
   */
  std::string Sample(
    vtkInkStyle* style, const vtkInkStyle::Input& input, vtkImageData* image, vtkPolyData* points);

  /**
   * The same of what a sampler reads itself, without all of it in memory, at values that are given or, of an
   * image, chosen.
   * @param style that notes a value that is chosen, and follows the sampler
   * @param sampler is given the parameters, and what is automatic; notes what memory has no room for
   */
  std::string SampleBy(vtkInkStyle* style, vtkInkIsoSurfaceAlgorithm* sampler, vtkPolyData* points);

  /**
   * Leaves out the parts of surfaces that are not wanted, where they may go on in other processes; all
   * processes call it at once after Sample.
   * @param points of each image of this process
   */
  void KeepParts(vtkInkStyle* style, const vtkInkStyle::Input& input,
    std::span<const vtkSmartPointer<vtkPolyData>> points);

  /**
   * The same surfaces as triangles with Normals, see InkIsoSurfaceMesh.h; after Prepare.
   * For what is drawn beside their points, it neither changes the frame nor says that there is none.
   * @param image that is sampled as a whole
   * @param mesh becomes them
   * @return what is wrong; empty if nothing is
   */
  std::string Mesh(vtkInkStyle* style, vtkImageData* image, vtkPolyData* mesh);

  /**
   * Fits the frame to the surfaces' points, for what is drawn of whole images beside them, or in their place,
   * so that it registers with them; as they are prepared, or quietly with what suits, if there is any. Not of
   * images from a port, whose pictures nobody fits.
   */
  void TakeFrame(vtkInkStyle* style, const vtkInkStyle::Input& input, std::span<vtkImageData* const> images,
    bool isPrepared);

  /// Notes it if there is no surface.
  void NoteWhereEmpty(vtkInkStyle* style, vtkPolyData* surface);

private:
  class SamplingOfParts;

  /// @param settings iso-values and all else
  std::string MeshOf(vtkInkStyle* style, vtkImageData* image, vtkDataArray* scalars,
    vtkInkIsoSurfaceSampler* settings, vtkPolyData* mesh) const;
  std::string AddCurvature(
    vtkInkStyle* style, vtkImageData* image, vtkDataArray* scalars, vtkPolyData* mesh) const;
  ink::ComponentSelection GetSelection() const;
  /// Whether something is chosen by what FindSmoothing finds.
  /// @param hasThickSlices whether an image of any process has; asked, by all at once, where it matters
  bool AsksForSuggestion(const std::function<bool()>& hasThickSlices) const;
  static bool HasThickSlices(vtkImageData* frame);
  /// Makes a sampler take values as labels or not, with borders, the cut, the smoothing's target and the
  /// interpolation that suit these.
  /// @param hasRoomForShapes whether memory has room for what distances reach into; asked where it matters
  /// @param isSolid whether caps suit what is sampled, labels or not; asked where it matters
  /// @return whether as labels
  bool TakeLabels(vtkInkIsoSurfaceAlgorithm* sampler, const ink::SuggestedSmoothing& suggested,
    const std::function<bool()>& hasRoomForShapes, const std::function<bool(bool labels)>& isSolid) const;
  /// Whether an image is less than half as thick as it is wide, as scans of a few slices.
  static bool IsSlab(vtkImageData* image);
  template <class Value>
  void Set(Value& parameter, Value value)
  {
    if (parameter != value)
    {
      parameter = value;
      this->Changed.Modified();
    }
  }
  /// Puts the one that IsoChoice asks for first.
  void Choose(std::vector<ink::IsoSuggestion>& suggestions) const;
  static std::vector<ink::IsoSuggestion> SuggestOf(vtkInkStyle* style, const InkWholeImages& images);
  ink::SuggestedSmoothing FindSmoothing(
    vtkInkStyle* style, const InkWholeImages& images, const std::vector<double>& values) const;
  /// The images of all processes, gathered when they are asked for first, by all processes at once.
  using Whole = std::function<const InkWholeImages&()>;
  int FindSubdivision(vtkInkStyle* style, std::span<vtkImageData* const> images, const Whole& whole,
    const std::vector<double>& values) const;
  /// Of a voxel, in world units: the shortest side, and how many times as long the longest one is.
  struct VoxelSides
  {
    double Shortest;
    double Ratio;
  };
  static VoxelSides MeasureVoxel(vtkImageData* image);
  /// The longest side of the box around all voxels, or less where the surfaces are small in it, as a lesion
  /// in a scan is, which fill the picture all the same.
  /// @param measure says how long the surface at a value is; 0: there is none
  static double FitLongest(
    double longest, const std::vector<double>& values, const std::function<double(double value)>& measure);
  /// Tells the style for which pictures it holds, and why it is not more.
  static void TakeSubdivision(vtkInkStyle* style, const InkSubdivision& chosen);
  vtkNew<vtkInkIsoSurfaceSampler> Sampler;
  std::string Scalars; ///< the array that is drawn; empty: the active one
  InkIsoValues IsoValues;
  double Smoothing = -1.0; ///< negative: as the image's noise asks for
  int SmoothingTarget = TARGET_AUTOMATIC;
  int Cut = CUT_AUTOMATIC;
  int IsoChoice = OUTERMOST;
  int LabelMap = LABELS_AUTOMATIC;
  int LabelBorders = BORDERS_AUTOMATIC;
  int ShapeBasedInterpolation = SHAPES_AUTOMATIC;
  bool ComputeCurvature = false;
  int Subdivision = 0; ///< 0: until cells are a small part of the picture
  vtkTimeStamp Changed;
  vtkTimeStamp ValuesChanged;
};

#endif
