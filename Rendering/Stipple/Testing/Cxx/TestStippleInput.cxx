// SPDX-License-Identifier: BSD-3-Clause
// What stipples are made from: missing and odd arrays, empty input, values that are not finite.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestStipples.h"
#include "StippleScene.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

vtkSmartPointer<vtkPolyData> Voxels()
{
  return InkTestStipples::SphereVoxels(1.0, 0.15, 6);
}

/// The elements of stipples in another order, as another number of processes would have them.
vtkSmartPointer<vtkPolyData> Reorder(vtkPolyData* data, const std::vector<vtkIdType>& order)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(data->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> cells;
  result->GetCellData()->CopyAllOn();
  result->GetCellData()->CopyAllocate(data->GetCellData());
  for (const vtkIdType id : order)
  {
    vtkIdType size;
    const vtkIdType* ids;
    data->GetVerts()->GetCellAtId(id, size, ids);
    result->GetCellData()->CopyData(data->GetCellData(), id, cells->InsertNextCell(static_cast<int>(size)));
    for (vtkIdType i = 0; i < size; ++i)
    {
      cells->InsertCellPoint(points->InsertNextPoint(data->GetPoint(ids[i])));
    }
  }
  result->SetPoints(points);
  result->SetVerts(cells);
  result->SetFieldData(data->GetFieldData());
  return result;
}

} // namespace

/// One message, once for an input, and nothing drawn.
TEST(StippleInput, Messages)
{
  const struct
  {
    const char* Expected;
    std::function<void(vtkPolyData*)> Spoil;
  } cases[] = {
    { "\"Normals\" with 3 components", [](vtkPolyData* d) { d->GetCellData()->RemoveArray("Normals"); } },
    { "\"Value\" with 1 component", [](vtkPolyData* d) { d->GetCellData()->RemoveArray("Value"); } },
    { "\"ElementSize\"", [](vtkPolyData* d) { d->GetFieldData()->RemoveArray("ElementSize"); } },
    { "\"ElementSize\"",
      [](vtkPolyData* d)
      {
        d->GetFieldData()
          ->GetArray("ElementSize")
          ->SetComponent(0, 0, std::numeric_limits<double>::quiet_NaN());
      } },
    { "one poly-vertex for each element", [](vtkPolyData* d) { d->SetVerts(nullptr); } },
    { "one poly-vertex for each element",
      [](vtkPolyData* d)
      {
        const vtkIdType first = 0;
        d->GetVerts()->InsertNextCell(1, &first);
      } },
    { "normal that is not zero",
      [](vtkPolyData* d) { vtkFloatArray::SafeDownCast(d->GetCellData()->GetArray("Normals"))->Fill(0.0); } },
  };
  for (const auto& [expected, spoil] : cases)
  {
    auto data = Voxels();
    spoil(data);
    StippleScene scene(data);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    const double ink = InkTestImage(scene.Window).Ink();
    scene.Window->Render();
    EXPECT_EQ(ink, 0.0) << "nothing drawn without " << expected;
    messages->Expect("spoilt", { expected });
  }
}

/// Two problems at a time: each is said once, whatever the number of pictures, and again for another input.
TEST(StippleInput, TwoMessages)
{
  auto data = Voxels();
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfTuples(data->GetNumberOfPoints());
  scalars->Fill(1.0);
  data->GetPointData()->SetScalars(scalars);
  StippleScene scene(data);
  scene.Mapper->ScalarVisibilityOn();
  for (int i = 0; i < 7; ++i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.0, 0.0, -10.0);
    scene.Mapper->AddClippingPlane(plane);
  }
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Window->Render();
  }
  EXPECT_EQ(messages->Messages.size(), 2)
    << "two messages in three pictures, found " << messages->Messages.size();
  data->Modified();
  scene.Window->Render();
  EXPECT_EQ(messages->Messages.size(), 4)
    << "two more for a changed input, found " << messages->Messages.size() - 2;
}

TEST(StippleInput, Empty)
{
  vtkNew<vtkPolyData> empty;
  StippleScene scene(empty);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  EXPECT_TRUE(InkTestImage(scene.Window).Ink() == 0.0 && messages->Messages.empty())
    << "an empty picture, silently";
  vtkNew<vtkFloatArray> marks;
  EXPECT_TRUE(
    !scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks) && marks->GetNumberOfTuples() == 0)
    << "no marks";
  scene.Mapper->SetInputData(Voxels());
  scene.Renderer->ResetCamera();
  EXPECT_GT(InkTestImage(scene.Window).Ink(), 10.0) << "stipples after that";
}

/// Elements and points with values that are not finite are passed over, the others are drawn as before.
TEST(StippleInput, PassedOver)
{
  auto data = Voxels();
  StippleScene scene(data);
  scene.AllOff();
  scene.Window->Render();
  vtkNew<vtkFloatArray> before;
  scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, before);

  auto spoilt = vtkSmartPointer<vtkPolyData>::New();
  spoilt->DeepCopy(data);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  spoilt->GetPoints()->SetPoint(6 * 10 + 2, nan, 0.0, 0.0);
  spoilt->GetPoints()->SetPoint(6 * 20 + 0, 0.0, infinite, 0.0);
  spoilt->GetCellData()->GetArray("Normals")->SetComponent(30, 1, nan);
  spoilt->GetCellData()->GetArray("Value")->SetComponent(40, 0, nan);
  StippleScene other(spoilt);
  other.AllOff();
  other.Renderer->GetActiveCamera()->DeepCopy(scene.Renderer->GetActiveCamera());
  other.Window->Render();
  vtkNew<vtkFloatArray> after;
  EXPECT_TRUE(other.Mapper->EvaluateMarks(other.Renderer, other.Actor, after)) << "marks of a spoilt input";
  int different = 0;
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
  {
    const vtkIdType cell = i / 6;
    const bool spoiltPoint = i == 62 || i == 120 || cell == 30 || cell == 40;
    EXPECT_TRUE(!spoiltPoint || after->GetComponent(i, 1) == 0.0) << "stipple " << i << " passed over";
    different += !spoiltPoint && std::abs(after->GetComponent(i, 1) - before->GetComponent(i, 1)) > 1e-3;
  }
  EXPECT_EQ(different, 0) << "the other stipples as before, but for " << different;
  EXPECT_GT(InkTestImage(other.Window).Ink(), 10.0) << "ink";
}

/// A single stipple, and field data that say nothing of kind and number.
TEST(StippleInput, Little)
{
  auto plane = InkTestStipples::PlaneSurface(1.0, 1, 1);
  plane->GetFieldData()->RemoveArray("ElementKind");
  plane->GetFieldData()->RemoveArray("StipplesPerElement");
  StippleScene scene(plane);
  scene.AllOff();
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 5.0);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Renderer->ResetCameraClippingRange(-1, 1, -1, 1, -1, 1);
  EXPECT_GT(InkTestImage(scene.Window).Ink(), 2.0) << "one stipple, " << InkTestImage(scene.Window).Ink();
}

/// An array of another picture takes the place of one, which all the others are younger than.
TEST(StippleInput, ExchangedArrays)
{
  auto older = vtkSmartPointer<vtkFloatArray>::New();
  older->SetName("Value");
  older->SetNumberOfValues(Voxels()->GetNumberOfCells());
  older->Fill(0.1);
  auto data = Voxels();
  StippleScene scene(data);
  const double before = InkTestImage(scene.Window).Ink();
  const vtkMTimeType time = scene.Mapper->GetUploadTime();
  auto younger = vtkSmartPointer<vtkDataArray>(data->GetCellData()->GetArray("Value"));
  data->GetCellData()->AddArray(older);
  const double pale = InkTestImage(scene.Window).Ink();
  EXPECT_TRUE(scene.Mapper->GetUploadTime() > time && pale < 0.1 * before)
    << "small values, ink " << before << " to " << pale;
  data->GetCellData()->AddArray(younger);
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), before) << "the first picture again";
}

/// Pictures are the same to the last pixel whatever the order of the elements, also where chance decides and
/// where pale dots are drawn more rarely; global ids, where there are any, are what chance goes by.
TEST(StippleInput, Order)
{
  auto data = InkTestStipples::SphereVoxels(1.0, 0.08, 6);
  std::vector<vtkIdType> order;
  for (vtkIdType part = 0; part < 3; ++part)
  {
    for (vtkIdType id = 2 - part; id < data->GetNumberOfCells(); id += 3)
    {
      order.push_back(id);
    }
  }
  for (const bool peeled : { false, true })
  {
    const auto draw = [&](vtkPolyData* stipples)
    {
      StippleScene scene(stipples);
      scene.Mapper->SetSmallElements(vtkInkStippleMapper::PROBABILITY);
      scene.Mapper->SetPixelsPerStipple(30.0);
      // In 8 bits.
      scene.Renderer->SetUseDepthPeeling(peeled);
      scene.Mapper->SetWarmCool(1.0);
      return InkTestImage(scene.Window);
    };
    const InkTestImage expected = draw(data);
    const int different = draw(Reorder(data, order)).CountDifferent(expected);
    EXPECT_TRUE(expected.Ink() > 100.0 && different == 0)
      << "the same picture in another order" << (peeled ? ", peeled" : "") << ", but for " << different
      << " pixels";

    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("Ids");
    for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
    {
      ids->InsertNextValue(id);
    }
    auto named = vtkSmartPointer<vtkPolyData>::New();
    named->ShallowCopy(data);
    named->GetCellData()->SetGlobalIds(ids);
    const InkTestImage byIds = draw(named);
    EXPECT_GT(byIds.CountDifferent(expected, 30), 100) << "other stipples by global ids";
    auto reordered = Reorder(data, order);
    vtkNew<vtkIdTypeArray> reorderedIds;
    reorderedIds->SetName("Ids");
    for (const vtkIdType id : order)
    {
      reorderedIds->InsertNextValue(id);
    }
    reordered->GetCellData()->SetGlobalIds(reorderedIds);
    EXPECT_EQ(draw(reordered).CountDifferent(byIds), 0) << "the same picture in another order by global ids";
  }
}
