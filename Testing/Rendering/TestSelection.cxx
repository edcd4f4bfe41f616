// SPDX-License-Identifier: BSD-3-Clause
#include "CutScene.h"
#include "Frames/SelectionImage.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkProp3DCollection.h"
#include "vtkPropPicker.h"
#include "vtkRenderedAreaPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTypeInt64Array.h"

#include <set>

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::Window;

/// The cut and the sphere in a window.
struct Selected
{
  explicit Selected(bool parallel)
  {
    Window.Renderer->AddActor(Scene.Cut);
    Window.Renderer->AddActor(Scene.Sphere);
    CutScene::Look(Window.Renderer, parallel);
    Selector->SetRenderer(Window.Renderer);
    Selector->SetArea(0, 0, Window::kWidth - 1, Window::kHeight - 1);
  }

  /// visit(pixel, what the pixel shows), but for pixels at edges.
  template <class Visit>
  void ForEachPixel(const Visit& visit)
  {
    const testing::VtkRays rays(
      Window.Renderer->GetActiveCamera(), Window::kWidth, Window::kHeight);
    for (unsigned int j = 1; j + 1 < Window::kHeight; ++j)
    {
      for (unsigned int i = 1; i + 1 < Window::kWidth; ++i)
      {
        const auto expected = CutScene::Meet(rays.At(i + 0.5, j + 0.5));
        bool edge = false;
        for (const double dx : { -1.0, 1.0 })
        {
          for (const double dy : { -1.0, 1.0 })
          {
            const auto beside = CutScene::Meet(rays.At(i + 0.5 + dx, j + 0.5 + dy));
            edge = edge || beside.seen != expected.seen ||
              beside.position.x * expected.position.x < 0.0 ||
              beside.position.y * expected.position.y < 0.0;
          }
        }
        if (!edge)
        {
          visit(std::array<unsigned int, 2>{ i, j }, expected);
        }
      }
    }
  }

  CutScene Scene;
  testing::Window Window;
  vtkNew<vtkHardwareSelector> Selector;
};

/// The lesser of the source cells of BoxGrid(2) at a point of the plane z = 0, which lies between
/// two.
std::int64_t CellBelow(const Vec3& x)
{
  return 1000 + (x.x > 0.0 ? 1 : 0) + (x.y > 0.0 ? 2 : 0);
}

vtkTypeInt64Array* SourceCells(vtkUnstructuredGrid* grid)
{
  return vtkTypeInt64Array::SafeDownCast(
    grid->GetFieldData()->GetArray((std::string(kMeshPrefix) + "SourceCell").c_str()));
}
} // namespace

TEST(Selection, PixelsAreTheirActorsAndTheirCells)
{
  for (const bool parallel : { false, true })
  {
    // Numbers of up to 24 bits take one pass, others two.
    for (const std::int64_t more : { std::int64_t{ 0 }, std::int64_t{ 5 } << 30U })
    {
      Selected selected(parallel);
      vtkTypeInt64Array* source = SourceCells(selected.Scene.Grid);
      for (vtkIdType e = 0; e < source->GetNumberOfTuples(); ++e)
      {
        source->SetValue(e, source->GetValue(e) + more);
      }
      ASSERT_TRUE(selected.Selector->CaptureBuffers());
      std::array<int, 3> count{};
      selected.ForEachPixel(
        [&](const std::array<unsigned int, 2>& pixel, const CutScene::Expected& expected)
        {
          ++count[static_cast<std::size_t>(expected.seen)];
          const auto info = selected.Selector->GetPixelInformation(pixel.data());
          ASSERT_EQ(info.Valid, expected.seen != CutScene::Seen::Nothing)
            << pixel[0] << ", " << pixel[1];
          if (expected.seen == CutScene::Seen::Sphere)
          {
            ASSERT_EQ(info.Prop, selected.Scene.Sphere);
          }
          if (expected.seen == CutScene::Seen::Cut)
          {
            ASSERT_EQ(info.Prop, selected.Scene.Cut);
            const std::int64_t cell = info.AttributeID - more - CellBelow(expected.position);
            ASSERT_TRUE(cell == 0 || cell == 4) << info.AttributeID;
          }
        });
      for (const int pixels : count)
      {
        EXPECT_GT(pixels, Window::kWidth * Window::kHeight / 20);
      }
    }
  }
}

TEST(Selection, TellsTheNumbersThatTheGridGives)
{
  Selected selected(true);
  vtkUnstructuredGrid* grid = selected.Scene.Grid;
  vtkNew<vtkTypeInt64Array> numbers;
  numbers->SetName(kSelectedCells);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    numbers->InsertNextValue(3 * SourceCells(grid)->GetValue(cell));
  }
  grid->GetCellData()->AddArray(numbers);
  ASSERT_TRUE(selected.Selector->CaptureBuffers());
  int cells = 0;
  selected.ForEachPixel(
    [&](const std::array<unsigned int, 2>& pixel, const CutScene::Expected& expected)
    {
      if (expected.seen == CutScene::Seen::Cut)
      {
        ++cells;
        const auto info = selected.Selector->GetPixelInformation(pixel.data());
        const std::int64_t cell = info.AttributeID - 3 * CellBelow(expected.position);
        ASSERT_TRUE(cell == 0 || cell == 12) << info.AttributeID;
      }
    });
  EXPECT_GT(cells, 100);
}

TEST(Selection, HoldsTheCellsThatAreSeen)
{
  Selected selected(false);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selected.Selector->Select());
  std::set<vtkIdType> columns;
  for (unsigned int k = 0; k < selection->GetNumberOfNodes(); ++k)
  {
    vtkSelectionNode* node = selection->GetNode(k);
    if (node->GetProperties()->Get(vtkSelectionNode::PROP()) == selected.Scene.Cut.Get())
    {
      auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
      for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
      {
        columns.insert((ids->GetValue(i) - 1000) % 4);
        EXPECT_TRUE(ids->GetValue(i) >= 1000 && ids->GetValue(i) < 1008) << ids->GetValue(i);
      }
    }
  }
  EXPECT_EQ(columns, (std::set<vtkIdType>{ 0, 1, 2, 3 }));
}

TEST(Selection, PropPickersFindTheCutAndPositionsOnIt)
{
  for (const bool parallel : { false, true })
  {
    Selected selected(parallel);
    vtkNew<vtkPropPicker> picker;
    const testing::VtkRays rays(
      selected.Window.Renderer->GetActiveCamera(), Window::kWidth, Window::kHeight);
    std::array<int, 3> count{};
    for (int j = 5; j < Window::kHeight; j += 37)
    {
      for (int i = 5; i < Window::kWidth; i += 41)
      {
        const auto expected = CutScene::Meet(rays.At(i + 0.5, j + 0.5));
        const int picked = picker->Pick(i, j, 0.0, selected.Window.Renderer);
        ++count[static_cast<std::size_t>(expected.seen)];
        ASSERT_EQ(picked != 0, expected.seen != CutScene::Seen::Nothing) << i << ", " << j;
        if (expected.seen == CutScene::Seen::Sphere)
        {
          EXPECT_EQ(picker->GetActor(), selected.Scene.Sphere);
        }
        if (expected.seen == CutScene::Seen::Cut)
        {
          EXPECT_EQ(picker->GetActor(), selected.Scene.Cut);
          // VTK takes the depth of the pixel's centre at its corner.
          const auto atCorner = CutScene::Meet(rays.At(i, j)).position;
          const double* x = picker->GetPickPosition();
          const double pixel = glm::length(atCorner - expected.position);
          EXPECT_NEAR(x[0], expected.position.x, pixel);
          EXPECT_NEAR(x[1], expected.position.y, pixel);
          EXPECT_NEAR(x[2], 0.0, pixel);
        }
      }
    }
    for (const int pixels : count)
    {
      EXPECT_GT(pixels, 0);
    }
  }
}

TEST(Selection, AreaPickersFindBothActors)
{
  Selected selected(false);
  vtkNew<vtkRenderedAreaPicker> picker;
  ASSERT_NE(
    picker->AreaPick(0, 0, Window::kWidth - 1, Window::kHeight - 1, selected.Window.Renderer), 0);
  EXPECT_NE(picker->GetProp3Ds()->IsItemPresent(selected.Scene.Cut), 0);
  EXPECT_NE(picker->GetProp3Ds()->IsItemPresent(selected.Scene.Sphere), 0);
}

TEST(Selection, ActorsSeenThroughAreHiddenFromIt)
{
  Selected selected(false);
  selected.Scene.Cut->GetProperty()->SetOpacity(0.5);
  selected.Selector->SetActorPassOnly(true);
  ASSERT_TRUE(selected.Selector->CaptureBuffers());
  selected.ForEachPixel(
    [&](const std::array<unsigned int, 2>& pixel, const CutScene::Expected& expected)
    {
      if (expected.seen == CutScene::Seen::Cut)
      {
        ASSERT_EQ(selected.Selector->GetPixelInformation(pixel.data()).Prop, selected.Scene.Cut);
      }
    });
  // Fully transparent actors are not selected.
  selected.Scene.Cut->GetProperty()->SetOpacity(0.0);
  ASSERT_TRUE(selected.Selector->CaptureBuffers());
  selected.ForEachPixel([&](const std::array<unsigned int, 2>& pixel, const CutScene::Expected&)
    { ASSERT_NE(selected.Selector->GetPixelInformation(pixel.data()).Prop, selected.Scene.Cut); });
}

TEST(Selection, PointsAreNoneOnACut)
{
  Selected selected(false);
  selected.Selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  ASSERT_TRUE(selected.Selector->CaptureBuffers());
  std::array<int, 3> all{};
  std::array<int, 3> found{};
  selected.ForEachPixel(
    [&](const std::array<unsigned int, 2>& pixel, const CutScene::Expected& expected)
    {
      const auto info = selected.Selector->GetPixelInformation(pixel.data());
      ASSERT_NE(info.Prop, selected.Scene.Cut);
      ++all[static_cast<std::size_t>(expected.seen)];
      found[static_cast<std::size_t>(expected.seen)] += info.Valid ? 1 : 0;
    });
  const auto of = [](const std::array<int, 3>& counts, CutScene::Seen seen)
  { return counts[static_cast<std::size_t>(seen)]; };
  EXPECT_EQ(of(found, CutScene::Seen::Sphere), of(all, CutScene::Seen::Sphere));
  // The sphere's lower half is hidden, but for the size of the points along its outline.
  EXPECT_LT(of(found, CutScene::Seen::Cut), of(all, CutScene::Seen::Cut) / 20);
}

TEST(Selection, TracesOnceForAllPassesAndPictures)
{
  Selected selected(false);
  for (int i = 0; i < 2; ++i)
  {
    ASSERT_TRUE(selected.Selector->CaptureBuffers());
    selected.Window.Render();
    CutScene::ExpectPicture(selected.Window, { 0, 0, Window::kWidth, Window::kHeight });
    EXPECT_EQ(selected.Scene.Mapper->GetNumberOfTraces(), 1);
  }
}

TEST(SelectionImage, IsOfTheNearestSampleThatIsShown)
{
  // Four pixels: an exact sample, one that is undecided, a transparent one before another sheet,
  // nothing.
  Frame frame;
  const Buffer buffers = Buffer::Position | Buffer::Verdict | Buffer::Element | Buffer::Color;
  frame.centres.Allocate(buffers, 4, 1);
  frame.centres.behind.resize(1);
  frame.centres.behind[0].Allocate(buffers, 4, 1);
  const auto put = [](SampleBuffers& sheet, std::size_t i, PixelVerdict verdict,
                     std::int64_t element, std::uint8_t alpha, double z)
  {
    sheet.position[i] = Vec3(0.0, 0.0, z);
    sheet.verdict[i] = static_cast<std::uint8_t>(verdict);
    sheet.element[i] = element;
    sheet.color[4 * i + 3] = alpha;
  };
  frame.centres.color.assign(16, 0);
  frame.centres.behind[0].color.assign(16, 0);
  put(frame.centres, 0, PixelVerdict::Exact, 1, 255, 0.0);
  put(frame.centres, 1, PixelVerdict::Unknown, -1, 255, 0.0);
  put(frame.centres, 2, PixelVerdict::Exact, 0, 0, 0.0);
  put(frame.centres.behind[0], 2, PixelVerdict::Exact, 1, 1, 0.5);
  const std::vector<std::int64_t> source{ 7, 0x0102030405 };
  const DepthRows rows{ { 0.0, 0.0, 1.0, 0.0 }, { 0.0, 0.0, 0.0, 1.0 } };

  SelectionPass pass;
  pass.needsCells = true;
  pass.shows = SelectionPass::Shows::CellLow;
  const SelectionImage low = MakeSelectionImage(pass, frame, rows, source, {});
  EXPECT_EQ(
    low.rgba, (std::vector<std::uint8_t>{ 5, 4, 3, 255, 0, 0, 0, 255, 5, 4, 3, 255, 0, 0, 0, 0 }));
  EXPECT_EQ(low.depths, (std::vector<float>{ 0.5F, 0.5F, 0.75F, kNoDepth }));
  pass.shows = SelectionPass::Shows::CellHigh;
  const SelectionImage high = MakeSelectionImage(pass, frame, rows, source, {});
  EXPECT_EQ(std::vector<std::uint8_t>(high.rgba.begin(), high.rgba.begin() + 4),
    (std::vector<std::uint8_t>{ 2, 1, 0, 255 }));

  // A selection of the actor alone also includes undecided pixels.
  pass = { .shows = SelectionPass::Shows::Prop, .color = { 9, 8, 7 }, .needsCells = false };
  const SelectionImage prop = MakeSelectionImage(pass, frame, rows, source, {});
  EXPECT_EQ(
    prop.rgba, (std::vector<std::uint8_t>{ 9, 8, 7, 255, 9, 8, 7, 255, 9, 8, 7, 255, 0, 0, 0, 0 }));
}
} // namespace pixelexact
