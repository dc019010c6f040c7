// SPDX-License-Identifier: BSD-3-Clause
// The image file that lines of contours are drawn with.
#include "StyleErrors.h"

#include "vtkInkContoursStyle.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkImageData.h"
#include "vtkPNGWriter.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <utility>

namespace
{

const std::string Pencil = INK_DATA_DIR "/pencil.png";

std::string WriteImage(const char* name, int type, int components)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(6, 4, 1);
  image->AllocateScalars(type, components);
  for (int i = 0; i < 24 * components; ++i)
  {
    image->SetScalarComponentFromDouble(
      i / components % 6, i / components / 6, 0, i % components, 7 * i % 256);
  }
  std::string file = testing::TempDir() + name;
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
  return file;
}

TEST(TextureFile, IsTheMappersTexture)
{
  vtkNew<vtkInkContoursStyle> style;
  vtkInkSilhouetteMapper* mapper = style->GetSilhouetteMapper();
  for (const int components : { 1, 4 })
  {
    const std::string file = WriteImage("texture.png", VTK_UNSIGNED_CHAR, components);
    ASSERT_TRUE(style->SetParameterAsString("Texture", file.c_str()));
    EXPECT_EQ(style->GetParameterAsString("Texture"), file);
    vtkImageData* texture = mapper->GetTexture();
    ASSERT_NE(texture, nullptr);
    EXPECT_EQ(texture->GetNumberOfScalarComponents(), components);
    EXPECT_EQ(texture->GetDimensions()[0], 6);
    EXPECT_EQ(texture->GetScalarComponentAsDouble(2, 3, 0, 0), 7 * 20 * components % 256);
    std::filesystem::remove(file);
  }
  ASSERT_TRUE(style->SetParameterAsString("Texture", ""));
  EXPECT_EQ(mapper->GetTexture(), nullptr);
}

TEST(TextureFile, WhatIsNoneIsRefused)
{
  const std::string text = testing::TempDir() + "text.png";
  std::ofstream(text) << "# No image\n\nBut text, with a title as that of a radiance map.\n";
  const std::string broken = testing::TempDir() + "broken.tif";
  std::ofstream(broken, std::ios::binary) << std::string("II*\0\0\0\0\0 and nothing", 20);
  const std::string colors = WriteImage("colors.png", VTK_UNSIGNED_CHAR, 3);
  const std::string deep = WriteImage("deep.png", VTK_UNSIGNED_SHORT, 1);
  vtkNew<vtkInkContoursStyle> style;
  ASSERT_TRUE(style->SetParameterAsString("Texture", Pencil.c_str()));
  vtkImageData* before = style->GetSilhouetteMapper()->GetTexture();
  ASSERT_NE(before, nullptr);
  for (const auto& [file, words] :
    std::initializer_list<std::pair<std::string, std::string>>{ { "nowhere.png", "which is no file" },
      { testing::TempDir(), "which is no file" }, { text, "which is no PNG, TIFF, JPEG or BMP" },
      { broken, "" }, { colors, "6 x 4 x 1 pixels of unsigned char with 3 components" },
      { deep, "6 x 4 x 1 pixels of unsigned short with 1 components" } })
  {
    const StyleErrors errors(style);
    EXPECT_FALSE(style->SetParameterAsString("Texture", file.c_str())) << file;
    ASSERT_EQ(errors.All.size(), 1u) << file;
    EXPECT_NE(errors.All[0].find("expected an image file of 8 bits"), std::string::npos) << errors.All[0];
    EXPECT_NE(errors.All[0].find("found '" + file + "'"), std::string::npos) << errors.All[0];
    EXPECT_NE(errors.All[0].find(words), std::string::npos) << errors.All[0];
    EXPECT_EQ(style->GetParameterAsString("Texture"), Pencil);
    EXPECT_EQ(style->GetSilhouetteMapper()->GetTexture(), before);
  }
  for (const std::string& file : { text, broken, colors, deep })
  {
    std::filesystem::remove(file);
  }
}

} // namespace
