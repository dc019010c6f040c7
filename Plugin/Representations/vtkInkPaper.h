// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInkPaper_h
#define vtkInkPaper_h

#include "vtkWeakPointer.h"

class vtkObject;
class vtkRenderer;

/// A plain background of a renderer in place of its own, while it draws: between pictures the renderer has
/// the background that it was given. Of several papers in a renderer the last attached is seen. No paper is
/// laid while points are picked, nor for a picture on a transparent background. A server of one process draws
/// it itself, so that its pictures of 8 bits are not rounded once more where the client lays them over its
/// paper.
class vtkInkPaper
{
public:
  vtkInkPaper() = default;
  ~vtkInkPaper();
  vtkInkPaper(const vtkInkPaper&) = delete;
  void operator=(const vtkInkPaper&) = delete;

  ///@{
  /// To be called where the representation enters and leaves a view.
  void Attach(vtkRenderer* renderer);
  void Detach();
  ///@}

  void SetVisible(bool visible);
  void SetFills(bool fills);
  void SetColor(double red, double green, double blue);
  bool GetFills() const;

private:
  void Lay(vtkObject*, unsigned long, void*);
  void LayOnServer(vtkObject*, unsigned long, void*);
  void TakeAway(vtkObject*, unsigned long, void*);

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observers[3] = { 0, 0, 0 };
  bool Visible = true;
  bool Fills = true;
  double Color[3] = { 1.0, 1.0, 1.0 };

  bool Laid = false;
  ///@{
  /// The renderer's own, while the paper is laid.
  double Background[3] = { 0.0, 0.0, 0.0 };
  double Alpha = 0.0;
  bool Gradient = false;
  bool Textured = false;
  ///@}
};

#endif
