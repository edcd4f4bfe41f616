// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/CommonWidths.h"

#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"

namespace pixelexact
{
namespace
{
void Write(const PackedWidths& widths, vtkMultiProcessStream& stream)
{
  stream << static_cast<int>(widths.size());
  for (const auto& [name, width] : widths)
  {
    stream << name << width;
  }
}

PackedWidths Read(vtkMultiProcessStream& stream)
{
  PackedWidths widths;
  int count = 0;
  stream >> count;
  for (int i = 0; i < count; ++i)
  {
    std::string name;
    int width = 0;
    stream >> name >> width;
    widths[name] = width;
  }
  return widths;
}
} // namespace

PackedWidths CommonWidths(const PackedWidths& own, vtkMultiProcessController* controller)
{
  if (controller == nullptr || controller->GetNumberOfProcesses() < 2)
  {
    return own;
  }
  vtkMultiProcessStream sent;
  Write(own, sent);
  std::vector<vtkMultiProcessStream> received;
  controller->Gather(sent, received, 0);
  vtkMultiProcessStream common;
  if (controller->GetLocalProcessId() == 0)
  {
    PackedWidths widths;
    for (vtkMultiProcessStream& stream : received)
    {
      Widen(widths, Read(stream));
    }
    Write(widths, common);
  }
  controller->Broadcast(common, 0);
  return Read(common);
}
} // namespace pixelexact
