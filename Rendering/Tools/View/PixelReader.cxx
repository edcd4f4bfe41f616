// SPDX-License-Identifier: BSD-3-Clause
#include "View/PixelReader.h"

#include "Base/Numbers.h"
#include "Base/Report.h"

#include <fmt/format.h>
#include <vtkHighOrderPicker.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <utility>

namespace pixelexact
{
namespace
{
/// Time from a movement of the pointer until the pixel is read.
constexpr int kMilliseconds = 15;
} // namespace

PixelReader::PixelReader() = default;
PixelReader::~PixelReader() = default;

void PixelReader::Wait(vtkRenderWindowInteractor& interactor)
{
  if (Timer != 0)
  {
    return;
  }
  // VTK's loop over the timers breaks where one is destroyed in its own event.
  if (Spent != 0)
  {
    interactor.DestroyTimer(Spent);
  }
  Timer = interactor.CreateOneShotTimer(kMilliseconds);
}

bool PixelReader::IsDue()
{
  if (Timer == 0)
  {
    return false;
  }
  Spent = std::exchange(Timer, 0);
  return true;
}

std::string PixelReader::Read(int x, int y, vtkRenderer& renderer)
{
  if (Picker->Pick(x, y, 0.0, &renderer) == 0 || Picker->GetVerdict() == 0)
  {
    return {};
  }
  const double* at = Picker->GetPickPosition();
  const std::string place = fmt::format("x = {}, {}, {}", Short(at[0]), Short(at[1]), Short(at[2]));
  if (Picker->GetVerdict() != 1)
  {
    return "unknown: no element could be decided\n" + place;
  }
  const double* xi = Picker->GetXi();
  const std::string name = Picker->GetFieldName();
  const auto text = [](double number) { return Short(WithoutRoundings(number, 1.0)); };
  return fmt::format("{}element {}\nxi = {}, {}, {}\n{}",
    name.empty() ? name : fmt::format("{} = {:.10g}, exact\n", name, Picker->GetValue()),
    Picker->GetElement(), text(xi[0]), text(xi[1]), text(xi[2]), place);
}
} // namespace pixelexact
