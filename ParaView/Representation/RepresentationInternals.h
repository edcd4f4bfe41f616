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
#include <functional>
#include <optional>
#include <set>
#include <string>

class vtkHighOrderPicker;

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
  bool ColorsCells = false; ///< the array is of cell data
  pixelexact::ShownRange Range;
  std::array<double, 2> FieldRange;
  std::array<double, 2> VisibleRange;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkDataObject> Delivered; ///< what the mapper shows
  unsigned long RenderObserver = 0;

  /// Of a pixel, see GetPicked.
  struct PickedPoint
  {
    std::array<double, 11> numbers;
    std::string text;
    PickedPoint() { Clear(); }
    void Clear();
  };
  std::array<int, 2> PickedPixel = { -1, -1 };
  PickedPoint Picked;  ///< of PickedPixel
  PickedPoint Pointed; ///< under the pointer
  std::function<std::string(int, int)> PointerSource;
  vtkIdType UnknownPixels = 0;                  ///< of several processes
  std::array<double, 2> SeenByAll{ 1.0, -1.0 }; ///< of these

  std::set<std::string> Selectors;
  bool HasBlockColors = false;
  bool HasBlockOpacities = false;
  std::set<std::string> Told; ///< so that each is told once
  pixelexact::ViewNotes Notes;

  static bool HasCells(vtkDataObject* data);
  /// Whether the array of the colours has a field's name and is not the field.
  [[nodiscard]] bool HasOtherColors(vtkDataObject* data) const;
  static bool HasSeveralProcesses();
  static bool IsFirstProcess();
  /// Tells selections of the cells of `data`, which ParaView extracts: element and source cell may
  /// have other numbers, in parts of a mesh and where cells were not converted.
  void NumberSelectedCells(vtkDataObject* data);
  /// What a pixel shows, of all processes, each of which calls it.
  void Pick(int x, int y, PickedPoint& point);
  void Describe(vtkHighOrderPicker* picker, PickedPoint& point);
  /// Of this process' part of the last picture; 1 and -1 where it shows no values.
  std::array<double, 2> OwnVisibleRange();
  /// Contours or edges, which a pixel's corners decide.
  bool HasLines();
  /// The data with coefficients; converted where some are plain. Throws pixelexact::Error.
  vtkSmartPointer<vtkDataObject> WithCoefficients(vtkDataObject* data);
};
