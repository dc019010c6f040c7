// SPDX-License-Identifier: BSD-3-Clause
/// A mapper to test what mappers share, and to start another one from: round dots where the points are.
#ifndef DotsMapper_h
#define DotsMapper_h

#include "InkShiftScale.h"
#include "vtkInkMapper.h"

#include <memory>

class DotsMapper : public vtkInkMapper
{
public:
  static DotsMapper* New();
  vtkTypeMacro(DotsMapper, vtkInkMapper);

  /// Windows that have the points on the GPU, of all mappers.
  static int NumberOfMarks;

  double InkColor[3] = { 0.0, 0.0, 0.0 };
  double Diameter = 9.0; ///< pixels, positive

protected:
  std::unique_ptr<InkMarks> MakeMarks(vtkOpenGLRenderWindow* window) override;
  bool UpdateMarks(InkMarks& marks) override;
  void DrawMarks(InkMarks& marks, const InkFrame& frame) override;

private:
  InkShiftScale Frame;
};

#endif
