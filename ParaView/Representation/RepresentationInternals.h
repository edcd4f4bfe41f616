// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ShownRange.h"
#include "vtkHighOrderBoundarySurface.h"
#include "vtkHighOrderIsoSurface.h"
#include "vtkHighOrderMapper.h"
#include "vtkPixelExactRepresentation.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkImplicitFunction.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <set>
#include <string>

struct vtkPixelExactRepresentation::Internals
{
  vtkNew<vtkHighOrderMapper> Mapper;
  vtkNew<vtkActor> Actor;
  int Surface = CUT;
  vtkSmartPointer<vtkImplicitFunction> Cut;
  vtkNew<vtkHighOrderBoundarySurface> Boundary;
  vtkNew<vtkHighOrderIsoSurface> Iso;

  vtkNew<vtkUnstructuredGridToHighOrderGrid> Convert;
  vtkSmartPointer<vtkDataObject> Shown; ///< on processes that have data
  std::array<double, 6> Bounds;

  std::string ColorArray;
  pixelexact::ShownRange Range;
  std::array<double, 2> FieldRange;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkDataObject> Delivered; ///< what the mapper shows
  std::array<int, 2> PickedPixel = { -1, -1 };
  std::array<double, 11> Picked;
  std::string PickedText;
  std::set<std::string> Selectors;
  bool HasBlockColors = false;
  bool HasBlockOpacities = false;
  std::set<std::string> Told; ///< so that each is told once

  /// The data with coefficients; converted where some are plain. Throws pixelexact::Error.
  vtkSmartPointer<vtkDataObject> WithCoefficients(vtkDataObject* data);
};
