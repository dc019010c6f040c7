// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkMapper
 * @brief   what mappers that draw ink have in common
 *
 * Updates its inputs, keeps what is on the GPU for each window it is drawn in, and calls what draws:
 * pictures, or for hardware selection, ids. What an input lacks is reported once, not in each picture. Face
 * culling does not concern ink: the back faces that an actor culls are left out by the marks themselves. Up
 * to 6 clipping planes.
 *
 * Another mapper can draw over one's marks, see SetOverlay: as strokes over stipples.
 *
 * A subclass makes its InkMarks for a window, brings them up to date, and draws them.
 *
 * @sa vtkInkSplattingLinesMapper vtkInkStippleMapper
 */
#ifndef vtkInkMapper_h
#define vtkInkMapper_h

#include "vtkInkRenderingCoreModule.h" // for the export macro
#include "vtkPolyDataMapper.h"

#include <functional> // for visiting the windows
#include <memory>     // for std::unique_ptr
#include <string>     // for error messages

class InkMarks;
struct InkFrame;
class vtkDataSet;
class vtkOpenGLRenderWindow;
class vtkUnsignedCharArray;

class VTKINKRENDERINGCORE_EXPORT vtkInkMapper : public vtkPolyDataMapper
{
public:
  vtkTypeMacro(vtkInkMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * When the marks were last sent to the GPU, for any window, as a modification time; 0 before the first
   * time. Each window that the mapper is drawn in has them once. Only a change of what they are made from
   * sends them again: no other parameter, and no camera.
   */
  vtkMTimeType GetUploadTime();

  ///@{
  /**
   * Another mapper, which draws over this one's marks: for the same actor, with the same clipping planes, and
   * not where ids are drawn. Default: none.
   */
  void SetOverlay(vtkInkMapper* overlay);
  vtkInkMapper* GetOverlay();
  ///@}

  ///@{
  /// Those of the overlay included.
  vtkMTimeType GetMTime() override;
  double* GetBounds() VTK_SIZEHINT(6) override;
  using vtkPolyDataMapper::GetBounds;
  ///@}

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool GetSupportsSelection() override { return true; }

protected:
  vtkInkMapper();
  ~vtkInkMapper() override;

  /// The input, of whichever type a subclass takes; null without one.
  vtkDataSet* GetInputDataSet() { return this->vtkMapper::GetInput(); }

  /// The marks of a window that has none, with its context current.
  virtual std::unique_ptr<InkMarks> MakeMarks(vtkOpenGLRenderWindow* window) = 0;

  /// Brings marks up to date with the input, which has points.
  /// @return whether there is anything to draw; what is wrong was reported
  virtual bool UpdateMarks(InkMarks& marks) = 0;

  /// Draws marks that are up to date, and leaves the OpenGL state as it was.
  virtual void DrawMarks(InkMarks& marks, const InkFrame& frame) = 0;

  /// The marks of a renderer's window, up to date; null where there is nothing to draw.
  InkMarks* FindMarksToDraw(vtkRenderer* renderer);

  /// The marks of a window as they are; null if it has none.
  InkMarks* GetMarks(vtkWindow* window) const;
  void ForEachMarks(const std::function<void(const InkMarks&)>& function) const;

  /// All finite points; of a grid, all of it.
  void ComputeBounds() override;
  /// All finite points but those that are ghosts, whether or not cells use them.
  /// @param ghosts `vtkGhostType` or null
  void ComputePointBounds(vtkUnsignedCharArray* ghosts);

  /// An error, unless it was reported since the input changed.
  void ReportOnce(const std::string& error);

private:
  vtkInkMapper(const vtkInkMapper&) = delete;
  void operator=(const vtkInkMapper&) = delete;

  void RenderOverlay(vtkRenderer* renderer, vtkActor* actor);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
