// SPDX-License-Identifier: BSD-3-Clause
// An image as readers give it that know no pieces: all to the first process, nothing to the others.
#ifndef InkTestPieces_h
#define InkTestPieces_h

#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

/// Gives its image whatever it is asked for. VTK does not even run it for other pieces than the first.
class InkTestSerialSource : public vtkImageAlgorithm
{
public:
  static InkTestSerialSource* New() { VTK_STANDARD_NEW_BODY(InkTestSerialSource); }
  vtkTypeMacro(InkTestSerialSource, vtkImageAlgorithm);

  vtkSmartPointer<vtkImageData> Image;

protected:
  InkTestSerialSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    output->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->Image->GetExtent(), 6);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkImageData::GetData(output)->ShallowCopy(this->Image);
    return 1;
  }
};

/// Hands its input on, as what ParaView puts behind every source and filter.
class InkTestHandingOn : public vtkImageAlgorithm
{
public:
  static InkTestHandingOn* New() { VTK_STANDARD_NEW_BODY(InkTestHandingOn); }
  vtkTypeMacro(InkTestHandingOn, vtkImageAlgorithm);

protected:
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override
  {
    vtkImageData::GetData(output)->ShallowCopy(vtkImageData::GetData(input[0]));
    return 1;
  }
};

/// One process's pipeline to `image`.
inline vtkSmartPointer<vtkImageAlgorithm> InkTestSerialPipeline(vtkImageData* image)
{
  auto source = vtkSmartPointer<InkTestSerialSource>::New();
  source->Image = image;
  auto handingOn = vtkSmartPointer<InkTestHandingOn>::New();
  handingOn->SetInputConnection(source->GetOutputPort());
  return handingOn;
}

#endif
