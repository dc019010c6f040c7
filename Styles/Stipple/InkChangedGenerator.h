// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkChangedGenerator_h
#define InkChangedGenerator_h

#include "vtkInkStippleGenerator.h"

/// Takes a generator's properties that a drawing changes back when it is done.
class InkChangedGenerator
{
public:
  explicit InkChangedGenerator(vtkInkStippleGenerator* generator)
    : Generator(generator)
    , Count(generator->GetNumberOfSurfaceStipples())
    , ListLength(generator->GetMaximumStipples())
    , Mode(generator->GetMaximumStipplesMode())
    , Smoothing(generator->GetSmoothing())
  {
  }
  ~InkChangedGenerator()
  {
    this->Generator->SetInputConnection(nullptr);
    this->Generator->SetStatistics(nullptr);
    this->Generator->SetPassScalars(false);
    this->Generator->SetNumberOfSurfaceStipples(this->Count);
    this->Generator->SetMaximumStipples(this->ListLength);
    this->Generator->SetMaximumStipplesMode(this->Mode);
    this->Generator->SetSmoothing(this->Smoothing);
  }
  InkChangedGenerator(const InkChangedGenerator&) = delete;
  void operator=(const InkChangedGenerator&) = delete;

private:
  vtkInkStippleGenerator* const Generator;
  const vtkIdType Count;
  const int ListLength;
  const int Mode;
  const double Smoothing;
};

#endif
