// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewLayout.h"

#include "Picture/Figure.h"
#include "View/ViewPanel.h"

#include <vtkActor2D.h>
#include <vtkCoordinate.h>
#include <vtkImageData.h>
#include <vtkImageMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cstdint>

namespace pixelexact
{
namespace
{
/// Part of the screen that a window without --size covers at most; the rest is its frame's.
constexpr double kPartOfScreen = 0.92;
constexpr int kLetters = 15; ///< of the help, in pixels

constexpr const char* kHelp = "drag         turn; shift: move; wheel: zoom\n"
                              "drag a ball  move or turn the cut, change its radius\n"
                              "p            handles on, off\n"
                              "l            contour lines\n"
                              "e            edges of elements\n"
                              "o            outline of the mesh's box\n"
                              "f, F         next, previous field\n"
                              "r            colours over what is seen\n"
                              "left, right  time step\n"
                              "s            save the figure\n"
                              "c            print its command\n"
                              "h            this help\n"
                              "q            close";
} // namespace

ShownImage::ShownImage()
{
  Mapper->SetInputData(Data);
  // Shows bytes as they are.
  Mapper->SetColorWindow(255.0);
  Mapper->SetColorLevel(127.5);
  Shown->SetMapper(Mapper);
  Shown->PickableOff();
}

ShownImage::~ShownImage() = default;

void ShownImage::Set(const Image& image, int left)
{
  Data->SetDimensions(image.width, image.height, 1);
  Data->AllocateScalars(VTK_UNSIGNED_CHAR, image.channels);
  std::ranges::copy(image.pixels, static_cast<std::uint8_t*>(Data->GetScalarPointer()));
  Data->Modified();
  Shown->SetPosition(left, 0.0);
}

ViewLayout::ViewLayout()
{
  Shown->SetMultiSamples(0);
  Shown->SetWindowName("PixelExact");
  Shown->SetNumberOfLayers(2);
  Back->InteractiveOff();
  Back->AddViewProp(&Figure.Actor());
  Back->AddViewProp(&Panel.Actor());
  Shown->AddRenderer(Back);
  Shown->AddRenderer(Inner);
  vtkTextProperty* letters = Help->GetTextProperty();
  Help->SetInput(kHelp);
  letters->SetFontFamilyToCourier();
  letters->SetFontSize(kLetters);
  letters->SetColor(0.0, 0.0, 0.0);
  letters->SetBackgroundColor(1.0, 1.0, 1.0);
  letters->SetBackgroundOpacity(0.85);
  letters->SetVerticalJustificationToTop();
  Help->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  Help->GetPositionCoordinate()->SetValue(0.01, 0.99);
  Help->VisibilityOff();
}

ViewLayout::~ViewLayout() = default;

void ViewLayout::AddOver(vtkRenderer& renderer)
{
  Over = &renderer;
  renderer.AddViewProp(Help);
  Shown->AddRenderer(&renderer);
}

void ViewLayout::PlacePicture(const std::array<int, 2>& corner, int width, int height)
{
  const std::array<int, 2> size = Size();
  const auto part = [](int pixel, int all)
  { return std::clamp(static_cast<double>(pixel) / all, 0.0, 1.0); };
  const double left = part(corner[0], size[0]);
  const double bottom = part(corner[1], size[1]);
  const double right = part(corner[0] + width, size[0]);
  const double top = part(corner[1] + height, size[1]);
  Inner->SetViewport(left, bottom, right, top);
  Over->SetViewport(left, bottom, right, top);
}

void ViewLayout::TurnHelp()
{
  Help->SetVisibility(Help->GetVisibility() == 0 ? 1 : 0);
}

std::array<int, 2> ViewLayout::Size() const
{
  const int* size = Shown->GetSize();
  return { size[0], size[1] };
}

ImageSize ViewLayout::LargestFigure()
{
  // A window that opens the display itself closes it while the interactor still reads its events.
  vtkNew<vtkRenderWindow> other;
  const int* screen = other->GetScreenSize();
  ImageSize size;
  size.height = std::min(size.height, static_cast<int>(kPartOfScreen * screen[1]));
  const int panel = ViewPanel::WidthBeside(FigureOptions().FontOf(size));
  size.width = std::min(size.width, static_cast<int>(kPartOfScreen * screen[0]) - panel);
  return size;
}

bool ViewLayout::IsInPicture(const std::array<int, 2>& at) const
{
  return Inner->IsInViewport(at[0], at[1]) != 0;
}
} // namespace pixelexact
