// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Appearance/Resolve.h"
#include "Trace/Compare/PictureErrors.h"
#include "Trace/Surfaces/BezierPatch.h"
#include "Trace/View.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImplicitFunction;
class vtkUnstructuredGrid;

namespace pixelexact
{
class HighOrderModel;
class Surface;
struct Shot;

/// The compared scene: a shot of one layer.
struct TradeScene
{
  const Shot* shot = nullptr;
  /// Makes the cut-surface for a model of the same mesh.
  std::function<std::shared_ptr<const Surface>(const std::shared_ptr<const HighOrderModel>&)>
    surface;
  // Input of VTK's filters for the same surface: a function, or a field's name, component (or
  // kMagnitude) and value.
  vtkSmartPointer<vtkImplicitFunction> function;
  std::string isoField;
  int isoComponent = 0;
  int isoComponents = 1; ///< of the iso-surface's field
  double isoValue = 0.0;
  std::vector<BezierPatch> patches; ///< patches of the surface
  std::vector<double> isoValues;    ///< of contours, ascending; none: no contours
  View view;                        ///< of the shot
  ResolvedAppearance resolved;      ///< of the view
  ColorMap map;
  std::array<double, 2> range{}; ///< of the colour map
};

/// Ways to make a picture.
enum class TradeFamily
{
  Exact,     ///< the ray tracer, with its settings
  Cut,       ///< vtkHighOrderLinearCut
  Resample,  ///< vtkHighOrderLinearResample and vtkCutter; not of iso-surfaces, as Cut
  Subdivide, ///< vtkHighOrderSubdivide and vtkCutter or vtkContourFilter
  Cells,     ///< these on the file's own high-order cells
  // For expressions with derivatives: VTK's filters compute values at points from the fields at the
  // points (NodalExpression.h).
  Gradient,     ///< as Subdivide
  GradientCells ///< as Cells
};
[[nodiscard]] const char* Name(TradeFamily family);
/// Whether a family's derivatives are vtkGradientFilter's.
[[nodiscard]] bool IsOfGradientFilter(TradeFamily family);
/// Describes these settings in tables.
inline constexpr const char* kGradientMethod =
  "VTK's Gradient filter and Calculator, from the fields at the nodes";

/// A setting of a family.
struct TradeSetting
{
  std::string name;
  TradeFamily family = TradeFamily::Exact;
  int number = 0; ///< resolution, nodes along the longest side, level; exact: index of the setting
  /// Spacing of the interpolation's points, up to a factor of the family's; 0: no spacing.
  double spacing = 0.0;
  std::optional<int> order = {}; ///< order to which an exact setting's field is truncated
};

/// Times and memory of making a picture twice.
struct TradeTime
{
  double first = 0.0;  ///< seconds, from a model in memory without bounds or trees
  double next = 0.0;   ///< seconds of the same cut again, with everything that was kept
  double bytes = -1.0; ///< at the peak, in addition to the model; less than 0: unknown
};

/// Makes pictures with one setting, and times itself.
class TradeRun
{
public:
  virtual ~TradeRun() = default;
  /// Makes the picture twice. Throws Error, also where it would not fit into memory.
  virtual TradeTime Measure() = 0;
  /// The picture that the last Measure made.
  [[nodiscard]] virtual Picture Show() = 0;
  /// A proven bound of the difference between the setting's and the exact picture's values,
  /// anywhere in the mesh; none: the setting has no such bound. Takes a while.
  [[nodiscard]] virtual std::optional<double> ProvenChange() const { return std::nullopt; }
  /// The number of triangles of the linear surface; 0: there is none.
  [[nodiscard]] virtual std::size_t Triangles() const { return 0; }
};

/// A copy of the shot's grid and its model, with neither bounds nor hierarchy yet.
struct FreshModel
{
  explicit FreshModel(const Shot& shot);
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::shared_ptr<HighOrderModel> model;
};

/// The settings of the exact side: precision, stride, samples, the field truncated to these orders
/// and, with contours, the method that classifies pixels.
[[nodiscard]] std::vector<TradeSetting> ExactSettings(
  bool contours, const std::vector<int>& orders);
/// Whether the setting is the exact picture or differs from it in values, not only in contours or
/// colours.
[[nodiscard]] bool HasOwnValues(const TradeSetting& setting);
/// Whether the cut-surface consists of elements' faces.
[[nodiscard]] bool IsOfFaces(const TradeScene& scene);
/// Whether the cut-surface consists of triangles of a file, or of Bezier patches.
[[nodiscard]] bool IsOfPieces(const TradeScene& scene);
/// Whether VTK's filters would cut cells that are not linear, with the fields at their points that
/// the family (Cells or GradientCells) needs.
[[nodiscard]] bool HasHighOrderCells(const TradeScene& scene, TradeFamily family);
/// Whether the field, or that of the iso-surface, is an expression with derivatives.
[[nodiscard]] bool HasDerivatives(const TradeScene& scene);
/// The reason why no setting with VTK's Gradient filter applies; empty where one does.
[[nodiscard]] std::string GradientObstacle(const TradeScene& scene);

/// The nodes of a regular grid over the volume: `number` along the longest side, and about the same
/// spacing along the others.
[[nodiscard]] std::array<int, 3> NodesAlong(vtkUnstructuredGrid* grid, int number);

[[nodiscard]] std::unique_ptr<TradeRun> MakeRun(
  const TradeScene& scene, const TradeSetting& setting);

// Implementations of MakeRun, by family.
[[nodiscard]] std::unique_ptr<TradeRun> MakeExactRun(
  const TradeScene& scene, const TradeSetting& setting);
[[nodiscard]] std::unique_ptr<TradeRun> MakeLinearRun(
  const TradeScene& scene, const TradeSetting& setting);
/// For scenes of faces, which have the family Subdivide only, without VTK's filters.
[[nodiscard]] std::unique_ptr<TradeRun> MakeFacesRun(
  const TradeScene& scene, const TradeSetting& setting);
/// For scenes of triangles and patches: each edge in 16, 32, ... parts.
[[nodiscard]] std::unique_ptr<TradeRun> MakePiecesRun(
  const TradeScene& scene, const TradeSetting& setting);
} // namespace pixelexact
