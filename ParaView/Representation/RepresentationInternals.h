// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ShownRange.h"
#include "SurfaceFile.h"
#include "ViewNotes.h"
#include "vtkHighOrderBoundarySurface.h"
#include "vtkHighOrderIsoSurface.h"
#include "vtkHighOrderJumpWalls.h"
#include "vtkHighOrderLayer.h"
#include "vtkHighOrderMapper.h"
#include "vtkHighOrderSurface.h"
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
#include <optional>
#include <set>
#include <string>

struct vtkPixelExactRepresentation::Internals
{
  explicit Internals(vtkPixelExactRepresentation* self);

  vtkNew<vtkHighOrderMapper> Mapper;
  vtkNew<vtkActor> Actor;
  int Surface = CUT;
  vtkSmartPointer<vtkImplicitFunction> Cut;
  vtkNew<vtkHighOrderBoundarySurface> Boundary;
  vtkNew<vtkHighOrderIsoSurface> Iso;
  bool HasWalls = false;
  vtkNew<vtkHighOrderJumpWalls> Walls; ///< of the iso-surface
  vtkNew<vtkHighOrderLayer> WallLayer; ///< the mapper's
  std::string SurfaceFile;
  vtkSmartPointer<vtkHighOrderSurface> OfFile; ///< null: not read yet, or in vain
  std::optional<std::string> FailedFile;       ///< so that it is told once

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
  pixelexact::ViewNotes Notes;

  static bool HasCells(vtkDataObject* data);
  static bool HasSeveralProcesses();
  /// Contours or edges, which a pixel's corners decide.
  bool HasLines();
  /// The data with coefficients; converted where some are plain. Throws pixelexact::Error.
  vtkSmartPointer<vtkDataObject> WithCoefficients(vtkDataObject* data);
};
