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
#include "vtkPixelExactClippedSurface.h"
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
  vtkNew<vtkPixelExactClippedSurface> Clipped;
  vtkWeakPointer<vtkDataObject> Described; ///< whose slices or clips the mapper draws
  vtkMTimeType DescribedTime = 0;
  bool LacksDescription = false; ///< reported once
  vtkNew<vtkHighOrderIsoSurface> Iso;
  bool HasWalls = false;
  vtkNew<vtkHighOrderJumpWalls> Walls; ///< of the iso-surface
  vtkNew<vtkHighOrderLayer> WallLayer; ///< the mapper's
  std::string SurfaceFile;
  vtkSmartPointer<vtkHighOrderSurface> OfFile; ///< null: not read yet, or reading failed
  std::optional<std::string> FailedFile;       ///< reported once

  vtkNew<vtkUnstructuredGridToHighOrderGrid> Convert;
  vtkSmartPointer<vtkDataObject> Shown; ///< on processes that have data
  std::array<double, 6> Bounds;

  std::string ColorArray;
  bool ColorsCells = false; ///< the array is of cell data
  /// Arrays that filters computed at points, which are polynomials through these values.
  std::set<std::string> Interpolated;
  pixelexact::ShownRange Range;
  std::array<double, 2> FieldRange;
  std::array<double, 2> VisibleRange;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkDataObject> Delivered; ///< what the mapper shows
  unsigned long RenderObserver = 0;

  /// Data of a pixel, see GetPicked.
  struct PickedPoint
  {
    /// Digits of numbers in the text that distinguish all doubles.
    static constexpr int kAllDigits = 17;
    /// Those that are easily read.
    static constexpr int kFewDigits = 6;

    std::array<double, 11> numbers;
    std::string text;
    int digits;
    explicit PickedPoint(int numberOfDigits)
      : digits(numberOfDigits)
    {
      Clear();
    }
    void Clear();
  };
  std::array<int, 2> PickedPixel = { -1, -1 };
  PickedPoint Picked{ PickedPoint::kAllDigits };  ///< of PickedPixel
  PickedPoint Pointed{ PickedPoint::kFewDigits }; ///< under the pointer
  std::function<std::string(int, int)> PointerSource;
  vtkIdType UnknownPixels = 0;                  ///< of several processes
  std::array<double, 2> SeenByAll{ 1.0, -1.0 }; ///< range of values on all processes

  std::set<std::string> Selectors;
  bool HasBlockColors = false;
  bool HasBlockOpacities = false;
  std::set<std::string> Reported; ///< messages that were reported once
  pixelexact::ViewNotes Notes;

  static bool HasCells(vtkDataObject* data);
  /// Whether the colours are those of an interpolated array.
  [[nodiscard]] bool ShowsInterpolated() const;
  /// Whether the colours' array has a field's name but is not the field.
  [[nodiscard]] bool HasOtherColors(vtkDataObject* data) const;
  static bool HasSeveralProcesses();
  static bool IsFirstProcess();
  /// Gives the cells of Shown their numbers in `data`, from which ParaView extracts selections.
  /// Element and source cell may have other numbers in parts of a mesh and where cells were not
  /// converted.
  void NumberSelectedCells(vtkDataObject* data);
  /// Finds what a pixel shows over all processes. All processes must call it.
  void Pick(int x, int y, PickedPoint& point);
  void Describe(vtkHighOrderPicker* picker, PickedPoint& point);
  /// The range of values in the last picture of this process' part; 1 and -1 where it shows none.
  std::array<double, 2> OwnVisibleRange();
  /// Whether contours or edges are drawn, which need values at pixels' corners.
  bool HasLines();
  /// Returns the data with coefficients; plain grids are converted. Throws pixelexact::Error.
  vtkSmartPointer<vtkDataObject> WithCoefficients(vtkDataObject* data);
};
