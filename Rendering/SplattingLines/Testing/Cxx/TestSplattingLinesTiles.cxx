// SPDX-License-Identifier: BSD-3-Clause
// Pictures drawn in tiles: what is done to lines as an image is what would be done to the whole picture, in
// bounded memory.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "Core/Hash.h"
#include "Raster/Despeckle.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

constexpr int Size = 160;

/// A plane of noisy normals, spots of all sizes, within a ring that is longer than any tile.
vtkSmartPointer<vtkPolyData> Noise()
{
  auto points = InkTestPoints::Plane(1.4, 0.03);
  vtkDataArray* normals = points->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const auto noise = [i](int axis)
    { return 0.5 * (ink::unitDouble(ink::hash(5, static_cast<std::uint64_t>(2 * i + axis))) - 0.5); };
    normals->SetTuple3(i, noise(0), noise(1), 1.0);
  }
  return InkTestPoints::Join(points, InkTestPoints::Torus(1.1, 0.08, 0.03));
}

/// The darkness of each pixel.
std::vector<unsigned char> InkOf(const InkTestImage& image)
{
  std::vector<unsigned char> ink;
  for (int y = 0; y < image.GetHeight(); ++y)
  {
    for (int x = 0; x < image.GetWidth(); ++x)
    {
      ink.push_back(static_cast<unsigned char>(255 - image.Gray(x, y)));
    }
  }
  return ink;
}

/// In MiB.
double PeakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

} // namespace

TEST(SplattingLinesTiles, AreAsTheWholePicture)
{
  SplattingLinesScene scene(Noise(), Size, Size);
  // Nothing reaches the picture's border, beyond which tiles look, too; and no ink is faint.
  scene.Mapper->SetLambda(1.2);
  scene.Mapper->SetTau(0.999);
  scene.Mapper->SetPhi(500.0);
  scene.Mapper->SetHardness(1.0);
  for (int tiles : { 2, 4 })
  {
    scene.Mapper->SetSpeckleLength(0.0);
    const std::vector<unsigned char> all = InkOf(InkTestImage(scene.Window, tiles));
    const double before = PeakMemory();
    for (double length : { 4.0, 20.0, 250.0 })
    {
      // Those longer than half a tile are not looked for.
      const double pixels = std::min(length * tiles, 0.5 * Size);
      std::vector<unsigned char> expected = all;
      ink::raster::despeckle({ expected, Size * tiles, Size * tiles }, static_cast<float>(pixels), 26);
      scene.Mapper->SetSpeckleLength(length);
      const std::vector<unsigned char> found = InkOf(InkTestImage(scene.Window, tiles));
      int removed = 0;
      int wrong = 0;
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        removed += all[i] != expected[i];
        wrong += std::abs(found[i] - expected[i]) > 1;
      }
      EXPECT_GT(removed, 500 * tiles)
        << "speckles of " << pixels << " pixels are there to be removed: " << removed;
      EXPECT_GT(
        std::count_if(found.begin(), found.end(), [](unsigned char ink) { return ink > 128; }), 400 * tiles)
        << "what is longer stays";
      // Without a margin, splats at a tile's border do not see what lies beyond.
      EXPECT_LE(wrong, 64) << tiles << " x " << tiles << " tiles without speckles of " << length
                           << " pixels like the whole picture; " << wrong << " pixels are not";
    }
    // A tile has four times a window's pixels at most, each in images of 44 bytes.
    const double more = PeakMemory() - before;
    const double most = 2.0 * 4.0 * Size * Size * 44.0 / 1048576.0;
    EXPECT_LT(more, most) << "at most " << most << " MiB more memory, found " << more;
  }
}
