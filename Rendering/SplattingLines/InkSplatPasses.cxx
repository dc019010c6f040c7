// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatPasses.h"

#include "InkDrawingProgress.h"
#include "InkFrame.h"
#include "InkPointSize.h"
#include "InkRenderTarget.h"
#include "InkShader.h"
#include "InkViewUniforms.h"

#include "InkSplatDepthFS.h"
#include "InkSplatGS.h"
#include "InkSplatIdFS.h"
#include "InkSplatLightFS.h"
#include "InkSplatVS.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace
{

/// The least radius of depth splats in pixels: it leaves no pixel between discs that are far away or seen
/// edge-on. By how much surfaces reach beyond their contours shows in the lines: in larger pictures it is a
/// part of the height, in thousandths.
constexpr double MinimumDepthRadius = 0.75;
constexpr double MinimumDepthThousandths = 1.5;

/// The least of illumination splats, in pixels, whatever the picture's height: Gaussians need some pixels.
constexpr double MinimumLightRadius = 1.5;

/// The same for splats as published, of which the paper says nothing: only so that no disc is degenerate.
constexpr double PublishedMinimumRadius = 0.01;

/// Discs beyond a contour take part in the illumination near it as long as f_i is greater than this.
constexpr double MinimumLight = -0.3;

/// As published, f_i may have any value.
constexpr double PublishedMinimumLight = -2.0;
constexpr double PublishedLeastLight = -1.0;

/// sigma_max over sigma_min (Zhang et al. 2014, section 3.2).
constexpr double WideOverNarrow = 1.6;

/// Where somebody watches: few enough for each hundredth of an ordinary picture to be seen to pass.
constexpr int PointsBetweenReports = 1 << 15;

/// By how many texels the viewport is wider than the target, so that points can be left out there.
constexpr int Margin = 4;

/// Discs of a part of the points must cover what all did: those of a part p of evenly spread points are
/// sqrt(1 / p) times as far from each other, and as the parts are less even than the whole, somewhat more.
double Growth(double fraction)
{
  return (1.45 - 0.45 * fraction) / std::sqrt(fraction);
}

/// By how much illumination splats are larger than the points' radii. Those of a part of the points are not
/// larger than all's while they cover the surface as well; otherwise pictures would differ by more than need
/// be.
double FindLightScale(const InkSplatSettings& splatting)
{
  return std::max(splatting.Lambda, std::min(splatting.Lambda, 1.0) * Growth(splatting.PointFraction));
}

/// How large in pixels a splat of some radius (in the points' unit), grown by another (in pixels), may be
/// anywhere beyond the near plane.
double LargestSplat(const InkViewUniforms& view, double radius, double minimumRadius)
{
  // An actor's scale may stretch discs.
  double unit = 0.0;
  for (int column = 0; column < 3; ++column)
  {
    const float* axis = view.MCVC.data() + 4 * column;
    unit = std::max<double>(unit, std::hypot(axis[0], axis[1], axis[2]));
  }
  const double nearW = view.DepthToClip[3] - view.DepthToClip[2] * view.DepthRange[0];
  const double pixels = std::hypot(radius * unit / (view.Pixel * nearW), minimumRadius);
  // Twice, because perspective stretches splats towards the corners; the vertex shader cuts them to the
  // viewport.
  const double viewport = std::max(view.Size[0], view.Size[1]);
  return std::min(viewport, 2.0 * 2.0 * pixels);
}

double FindDepthRadius(const InkViewUniforms& view)
{
  return std::max(MinimumDepthRadius, 1e-3 * MinimumDepthThousandths * view.PictureHeight);
}

} // namespace

InkSplatPasses::InkSplatPasses(vtkOpenGLRenderWindow* window)
  : Window(window)
{
  this->LargestSprite = InkFindLargestPoint();
}

InkSplatPasses::~InkSplatPasses()
{
  this->Buffers->ReleaseGraphicsResources(this->Window);
  this->Order->ReleaseGraphicsResources();
}

double InkSplatPasses::FindMinimumRadius(const InkViewUniforms& view, const InkSplatSettings& splatting)
{
  return splatting.AsPublished
    ? PublishedMinimumRadius
    : std::max(MinimumLightRadius, 1e-3 * splatting.MinimumRadius * view.PictureHeight);
}

std::array<int, 4> InkSplatPasses::FindExtent(
  const InkViewUniforms& view, const InkSplatSettings& splatting, int around) const
{
  const std::array<int, 4> all{ 0, 0, view.Size[0], view.Size[1] };
  const double radius = Growth(splatting.PointFraction) * this->LargestRadius;
  double low[2] = { HUGE_VAL, HUGE_VAL };
  double high[2] = { -HUGE_VAL, -HUGE_VAL };
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] =
        corner >> axis & 1 ? this->Bounds[2 * axis + 1] + radius : this->Bounds[2 * axis] - radius;
    }
    double inView[4];
    double inClip[4];
    for (int row = 0; row < 4; ++row)
    {
      inView[row] = 0.0;
      for (int column = 0; column < 4; ++column)
      {
        inView[row] += view.MCVC[4 * column + row] * point[column];
      }
    }
    for (int row = 0; row < 4; ++row)
    {
      inClip[row] = 0.0;
      for (int column = 0; column < 4; ++column)
      {
        inClip[row] += view.VCDC[4 * column + row] * inView[column];
      }
    }
    if (!(inClip[3] > 0.0))
    {
      return all;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      const double pixel = 0.5 * (inClip[axis] / inClip[3] + 1.0) * view.Size[axis];
      low[axis] = std::min(low[axis], pixel);
      high[axis] = std::max(high[axis], pixel);
    }
  }
  // Discs grow on the screen.
  const double grown = 2.0 + FindDepthRadius(view) + around;
  std::array<int, 4> extent;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double size = view.Size[axis];
    extent[axis] = static_cast<int>(std::clamp(std::floor(low[axis] - grown), 0.0, size));
    extent[2 + axis] = static_cast<int>(std::clamp(std::ceil(high[axis] + grown), 0.0, size)) - extent[axis];
  }
  return extent;
}

double InkSplatPasses::FewestTexels(double sigma)
{
  return std::max(2.5, 1.0 / sigma);
}

int InkSplatPasses::FindTexel(const InkViewUniforms& view, const InkSplatSettings& splatting, int limit) const
{
  // In the middle of the points, facing the viewer.
  const double w = view.DepthToClip[2] * view.MCVC[14] + view.DepthToClip[3];
  const double scale = FindLightScale(splatting);
  const double radius = w > 0.0 ? scale * this->LargestRadius * view.Unit / (view.Pixel * w) : 0.0;
  int texel = 1;
  // Some of the splats are seen from the side.
  while (2 * texel <= limit && radius >= 1.3 * FewestTexels(splatting.Sigma) * 2 * texel)
  {
    texel *= 2;
  }
  return texel;
}

vtkShaderProgram* InkSplatPasses::Begin(
  const char* fragmentShader, std::string features, const InkViewUniforms& view, const Splats& splats)
{
  const bool sprites =
    LargestSplat(view, splats.RadiusScale * this->LargestRadius, splats.MinimumRadius) / splats.Texel <=
    this->LargestSprite;
  const bool wider = sprites && fragmentShader != InkSplatIdFS;
  const int margin = wider ? Margin : 0;
  if (wider)
  {
    features += InkDefine("INK_MARGIN " + std::to_string(Margin) + ".0");
  }
  if (this->HasEdges)
  {
    features += InkDefine("INK_EDGES");
  }
  features += view.FindFeatures();
  InkShaderPass& pass = this->Passes.Find(InkWithFeatures(InkSplatVS, features),
    sprites ? "" : InkWithFeatures(InkSplatGS, features), InkWithFeatures(fragmentShader, features));
  vtkShaderProgram* program = pass.Begin(this->Window, this->Buffers->GetMTime(),
    [this](vtkShaderProgram* made, vtkOpenGLVertexArrayObject* vertexArray)
    { this->Buffers->AddAllAttributesToVAO(made, vertexArray); });
  if (!program)
  {
    return nullptr;
  }
  this->Current = &pass;

  view.SetUniforms(program);
  const int texel = splats.Texel;
  const int columns = (view.Size[0] + texel - 1) / texel + margin;
  const int rows = (view.Size[1] + texel - 1) / texel;
  if (wider)
  {
    this->Window->GetState()->vtkglViewport(0, 0, columns, rows);
  }
  const float target[2] = { static_cast<float>(columns * texel), static_cast<float>(rows * texel) };
  program->SetUniform2f("targetSize", target);
  program->SetUniformf("texel", static_cast<float>(texel));
  program->SetUniformf("radiusScale", static_cast<float>(splats.RadiusScale));
  program->SetUniformf("minimumRadius", static_cast<float>(splats.MinimumRadius));
  program->SetUniformf("minimumLight", 0.0f);
  const double rim = std::min(
    InkSplatTolerance, InkSplatMiddleTolerance + InkSplatToleranceGrowth * std::pow(splats.RadiusScale, 2));
  const float nearness[2] = { static_cast<float>(InkSplatMiddleTolerance / InkSplatTolerance),
    static_cast<float>(rim / InkSplatTolerance) };
  const float everywhere[2] = { 1.0f, 1.0f };
  program->SetUniformf("tolerance", static_cast<float>(InkSplatTolerance));
  program->SetUniform2f("nearness", splats.Uniform ? everywhere : nearness);
  program->SetUniformf("slack", static_cast<float>(splats.Slack));
  return program;
}

void InkSplatPasses::DrawPoints(double fraction, InkDrawingProgress& progress)
{
  const InkPointSizeByShader pointSize;
  const bool ordered = fraction < 1.0 && this->Ordered;
  const int count =
    ordered ? static_cast<int>(std::ceil(fraction * this->NumberOfPoints)) : this->NumberOfPoints;
  const int step = progress.IsWatched() ? PointsBetweenReports : count;
  if (ordered)
  {
    this->Order->Bind();
  }
  for (int first = 0; first < count; first += step)
  {
    const int now = std::min(step, count - first);
    if (ordered)
    {
      const std::size_t offset = sizeof(std::uint32_t) * static_cast<std::size_t>(first);
      glDrawElements(GL_POINTS, now, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
    }
    else
    {
      glDrawArrays(GL_POINTS, first, now);
    }
    progress.Report(static_cast<double>(first + now) / count);
  }
  if (ordered)
  {
    this->Order->Release();
  }
  this->Current->End();
}

void InkSplatPasses::DrawDepth(const InkViewUniforms& view, const InkSplatSettings& splatting,
  InkDrawingProgress& progress, Sheet sheet, const InkRenderTarget* image)
{
  std::string features = InkDefine("INK_DEPTH");
  if (sheet == Sheet::Hidden)
  {
    features += InkDefine("INK_PEEL");
  }
  if (sheet == Sheet::Back)
  {
    features += InkDefine("INK_BACK");
  }
  if (splatting.Colors)
  {
    features += InkDefine("INK_COLORS");
  }
  const bool published = splatting.AsPublished;
  const double minimum = published ? PublishedMinimumRadius : FindDepthRadius(view);
  // Two discs of one sheet reach beyond it by that much each.
  const double slack = published ? InkSplatTolerance * minimum : 2.0 * minimum;
  vtkShaderProgram* program = this->Begin(
    InkSplatDepthFS, features, view, { Growth(splatting.PointFraction), minimum, slack, published });
  if (!program)
  {
    return;
  }
  const bool backs = sheet == Sheet::Hidden ? splatting.PeelBackFaces : sheet != Sheet::Front;
  program->SetUniformi("backFaces", view.BackFaces && backs);
  std::optional<InkRenderTarget::Reading> reading;
  if (image)
  {
    program->SetUniformi("surface", reading.emplace(*image->GetTexture()).GetUnit());
    program->SetUniformi("probeCount", 4);
  }
  this->DrawPoints(splatting.PointFraction, progress);
}

void InkSplatPasses::DrawLight(const InkViewUniforms& view, const InkSplatSettings& splatting,
  InkDrawingProgress& progress, const InkRenderTarget& surface, bool hidden, int texel,
  const std::array<double, 2>& widths)
{
  const double minimum = FindMinimumRadius(view, splatting);
  const double scale = FindLightScale(splatting);
  const std::string features = InkDefine("INK_LIGHT") + (texel > 1 ? InkDefine("INK_COARSE") : "");
  vtkShaderProgram* program = this->Begin(InkSplatLightFS, features, view,
    { scale, minimum, splatting.AsPublished ? 0.0 : InkSplatTolerance * minimum, splatting.AsPublished,
      texel });
  if (!program)
  {
    return;
  }
  const InkRenderTarget::Reading reading(*surface.GetTexture());
  program->SetUniformi("surface", reading.GetUnit());
  program->SetUniformi("backFaces", view.BackFaces && (!hidden || splatting.PeelBackFaces));
  program->SetUniformf(
    "minimumLight", static_cast<float>(splatting.AsPublished ? PublishedMinimumLight : MinimumLight));
  program->SetUniformf("leastLight", static_cast<float>(splatting.AsPublished ? PublishedLeastLight : 0.0));
  // Sixteen bits hold numbers up to 65504.
  program->SetUniformf("largestWeight", splatting.HalfFloats ? 256.0f : InkNoSurface);
  program->SetUniformf("referenceRadius", static_cast<float>(scale * this->LargestRadius));
  // The paper tests each pixel of the visible surface (section 3.3), and of hidden layers each splat, where
  // its center is (section 5.2). Otherwise splats that are hidden altogether are left out first, which is
  // quicker.
  program->SetUniformi("probeCount", !splatting.AsPublished ? 4 : hidden ? 0 : -1);
  program->SetUniformi("bySplat", splatting.AsPublished && hidden);
  const float limits[2] = { static_cast<float>(widths[0]), static_cast<float>(widths[1]) };
  program->SetUniform2f("widths", limits);
  const double narrow = splatting.Sigma;
  const double wide = WideOverNarrow * narrow;
  const float falloff[2] = { static_cast<float>(0.5 / (narrow * narrow)),
    static_cast<float>(0.5 / (wide * wide)) };
  float rim[2] = { 0.0f, 0.0f };
  if (!splatting.AsPublished)
  {
    rim[0] = std::exp(-falloff[0]);
    rim[1] = std::exp(-falloff[1]);
  }
  program->SetUniform2f("falloff", falloff);
  program->SetUniform2f("rim", rim);
  this->DrawPoints(splatting.PointFraction, progress);
}

void InkSplatPasses::DrawIds(const InkViewUniforms& view, const InkFrame& frame)
{
  const std::string features = InkDefine("INK_ID") + (this->HasSources ? InkDefine("INK_SOURCES") : "");
  if (vtkShaderProgram* program =
        this->Begin(InkSplatIdFS, features, view, { 1.0, FindDepthRadius(view), 0.0 }))
  {
    frame.SetOrigin(program);
    frame.Ids->SetUniforms(program);
    this->DrawPoints(1.0, frame.Progress);
  }
}
