// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStippleControls
 * @brief   a few sliders for the many parameters of a vtkInkStippleMapper
 *
 * The higher of two levels of control (Lu et al. 2003, section 6): each slider sets several of the mapper's
 * k's, and a preset sets all sliders and what goes with them. Apply hands the result to a mapper, or
 * SetMapper makes one follow; its k's can be changed one by one after that. Sliders switch no enhancement
 * off, so pictures change little by little all the way; the mapper's own switches do. Positions of sliders
 * are kept within 0..1; what is no number is refused with an error.
 *
 * @sa vtkInkStippleMapper
 */
#ifndef vtkInkStippleControls_h
#define vtkInkStippleControls_h

#include "vtkInkRenderingStippleModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for std::unique_ptr

class vtkInkStippleMapper;

class VTKINKRENDERINGSTIPPLE_EXPORT vtkInkStippleControls : public vtkObject
{
public:
  static vtkInkStippleControls* New();
  vtkTypeMacro(vtkInkStippleControls, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The kind of drawing to start from: anatomy (default), bone, soft-tissue, engineering,
   * plate-white-on-black or as-published (T is Table 1's product to the letter: ValueEffect is 1, and
   * PixelsPerStipple 1). Sets all sliders. Capitals and what separates words do not count ("Soft Tissue");
   * GetPreset and GetPresetName have the one spelling. An unknown name is an error and changes nothing.
   */
  bool SetPreset(const char* name);
  const char* GetPreset();
  void SetPresetToAnatomy() { this->SetPreset("anatomy"); }
  void SetPresetToBone() { this->SetPreset("bone"); }
  void SetPresetToSoftTissue() { this->SetPreset("soft-tissue"); }
  void SetPresetToEngineering() { this->SetPreset("engineering"); }
  void SetPresetToPlateWhiteOnBlack() { this->SetPreset("plate-white-on-black"); }
  void SetPresetToAsPublished() { this->SetPreset("as-published"); }
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index); ///< null out of range
  ///@}

  /// Sets all sliders to where the preset has them.
  void Reset();

  ///@{
  /**
   * Emphasis on boundaries (BoundaryBase, BoundaryGain): more ink with a larger one. 0 to 1; default: the
   * preset's.
   */
  void SetGradient(double gradient);
  double GetGradient();
  ///@}

  ///@{
  /**
   * Sharpness of boundaries, silhouettes and shades (BoundaryExponent, SilhouetteExponent, LightingExponent):
   * less ink, in a smaller region, with a larger one. 0 to 1; default: the preset's.
   */
  void SetSharpness(double sharpness);
  double GetSharpness();
  ///@}

  ///@{
  /**
   * How much silhouettes and light count (SilhouetteGain, LightingExponent): the rim is darker and the middle
   * lighter with a larger one. 0 (hardly at all) to 1; default: the preset's.
   */
  void SetOrientation(double orientation);
  double GetOrientation();
  ///@}

  ///@{
  /**
   * How much nearer parts stand out (DistanceExponent, DistanceSize). 0 (only what lies at the very ends) to
   * 1; default: the preset's.
   */
  void SetDistance(double distance);
  double GetDistance();
  ///@}

  ///@{
  /**
   * How see-through weak boundaries are (InteriorExponent, InteriorSize): less ink with a larger one. 0 (not
   * at all) to 1; default: the preset's.
   */
  void SetInterior(double interior);
  double GetInterior();
  ///@}

  ///@{
  /**
   * How far warm and cool colors replace the ink (WarmCool). 0 to 1; default: the preset's.
   */
  void SetColor(double color);
  double GetColor();
  ///@}

  /**
   * Hands the sliders' k's, and the preset's size and room of stipples with their unit, FadeBySize, ink color
   * and LightInk, to a mapper.
   */
  void Apply(vtkInkStippleMapper* mapper);

  ///@{
  /**
   * A mapper that follows: a slider sets what it stands for at once, and nothing else, so that the rest stays
   * as it was chosen; SetPreset and Reset hand over all that Apply does. Default: none.
   */
  void SetMapper(vtkInkStippleMapper* mapper);
  vtkInkStippleMapper* GetMapper();
  ///@}

  /// The color of the paper that goes with the preset, for the renderer's background: white or black.
  void GetPaperColor(double rgb[3]);

protected:
  vtkInkStippleControls();
  ~vtkInkStippleControls() override;

private:
  vtkInkStippleControls(const vtkInkStippleControls&) = delete;
  void operator=(const vtkInkStippleControls&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
