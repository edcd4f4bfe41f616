// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SeenCut.h"

#include "Core/Base/Error.h"

#include <algorithm>

namespace pixelexact
{
vtkMTimeType SeenCut::Latest(vtkMTimeType time) const
{
  time = function ? std::max(time, function->GetMTime()) : time;
  return camera ? std::max(time, camera->GetMTime()) : time;
}

void SeenCut::Print(ostream& os, vtkIndent indent, const int size[2]) const
{
  os << indent << "CutFunction: " << (function ? function->GetClassName() : "(none)") << "\n";
  os << indent << "Camera: " << (camera ? "" : "(none)") << "\n";
  os << indent << "Size: " << size[0] << " " << size[1] << "\n";
}

void SeenCut::Require(const int size[2]) const
{
  if (!function)
  {
    throw Error("there is no cut function; give one with SetCutFunction.");
  }
  if (size[0] < 1 || size[1] < 1)
  {
    throw Error("Size: there must be at least a pixel each way.");
  }
}
} // namespace pixelexact
