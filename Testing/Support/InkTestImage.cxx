// SPDX-License-Identifier: BSD-3-Clause
#include "InkTestImage.h"

#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cstdlib>

InkTestImage::InkTestImage(vtkRenderWindow* window, int scale, bool alpha)
{
  window->Render();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->ReadFrontBufferOff();
  filter->SetScale(scale);
  filter->SetShouldRerender(scale != 1);
  if (alpha)
  {
    filter->SetInputBufferTypeToRGBA();
  }
  filter->Update();
  this->Data = filter->GetOutput();
}

int InkTestImage::GetWidth() const
{
  return this->Data->GetDimensions()[0];
}

int InkTestImage::GetHeight() const
{
  return this->Data->GetDimensions()[1];
}

int InkTestImage::Channel(int x, int y, int channel) const
{
  return static_cast<const unsigned char*>(this->Data->GetScalarPointer(x, y, 0))[channel];
}

int InkTestImage::Gray(int x, int y) const
{
  return (this->Channel(x, y, 0) + this->Channel(x, y, 1) + this->Channel(x, y, 2)) / 3;
}

int InkTestImage::CountDark(int x0, int y0, int x1, int y1, int brightness) const
{
  int count = 0;
  for (int y = std::max(0, y0); y < std::min(y1, this->GetHeight()); ++y)
  {
    for (int x = std::max(0, x0); x < std::min(x1, this->GetWidth()); ++x)
    {
      count += this->Gray(x, y) < brightness;
    }
  }
  return count;
}

int InkTestImage::CountDark(int brightness) const
{
  return this->CountDark(0, 0, this->GetWidth(), this->GetHeight(), brightness);
}

double InkTestImage::Ink() const
{
  double ink = 0.0;
  for (int y = 0; y < this->GetHeight(); ++y)
  {
    for (int x = 0; x < this->GetWidth(); ++x)
    {
      ink += 1.0 - this->Gray(x, y) / 255.0;
    }
  }
  return ink;
}

int InkTestImage::CountDifferent(const InkTestImage& other, int tolerance) const
{
  const int channels = this->Data->GetNumberOfScalarComponents();
  if (this->GetWidth() != other.GetWidth() || this->GetHeight() != other.GetHeight() ||
    channels != other.Data->GetNumberOfScalarComponents())
  {
    return this->GetWidth() * this->GetHeight();
  }
  int count = 0;
  for (int y = 0; y < this->GetHeight(); ++y)
  {
    for (int x = 0; x < this->GetWidth(); ++x)
    {
      bool different = false;
      for (int channel = 0; channel < channels; ++channel)
      {
        different =
          different || std::abs(this->Channel(x, y, channel) - other.Channel(x, y, channel)) > tolerance;
      }
      count += different;
    }
  }
  return count;
}

void InkTestImage::Write(const std::string& path) const
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(this->Data);
  writer->SetFileName(path.c_str());
  writer->Write();
}
