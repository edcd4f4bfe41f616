// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellBasis.h"

#include "Core/Base/Error.h"
#include "Core/Basis/LineFunctions.h"
#include "Core/Shape/Shape.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIdList.h"
#include "vtkPoints.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
vtkSmartPointer<vtkCell> Instantiate(int type)
{
  return vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
}

struct FixedCell
{
  int type;
  int points;
  Space space; ///< the smallest that holds the cell's functions
};

constexpr auto kCollapsed = Form::Collapsed;
constexpr FixedCell kFixedCells[] = {
  { VTK_TRIANGLE, 3, { Shape::Prism, kCollapsed, { 1, 0, 1 } } },
  { VTK_QUADRATIC_TRIANGLE, 6, { Shape::Prism, kCollapsed, { 2, 0, 2 } } },
  { VTK_BIQUADRATIC_TRIANGLE, 7, { Shape::Prism, kCollapsed, { 3, 0, 3 } } },
  { VTK_PIXEL, 4, { Shape::Hexahedron, kCollapsed, { 1, 1, 0 } } },
  { VTK_QUAD, 4, { Shape::Hexahedron, kCollapsed, { 1, 1, 0 } } },
  { VTK_QUADRATIC_LINEAR_QUAD, 6, { Shape::Hexahedron, kCollapsed, { 2, 1, 0 } } },
  { VTK_QUADRATIC_QUAD, 8, { Shape::Hexahedron, kCollapsed, { 2, 2, 0 } } },
  { VTK_BIQUADRATIC_QUAD, 9, { Shape::Hexahedron, kCollapsed, { 2, 2, 0 } } },
  { VTK_TETRA, 4, { Shape::Tetrahedron, kCollapsed, { 1, 1, 1 } } },
  { VTK_QUADRATIC_TETRA, 10, { Shape::Tetrahedron, kCollapsed, { 2, 2, 2 } } },
  { VTK_VOXEL, 8, { Shape::Hexahedron, kCollapsed, { 1, 1, 1 } } },
  { VTK_HEXAHEDRON, 8, { Shape::Hexahedron, kCollapsed, { 1, 1, 1 } } },
  { VTK_QUADRATIC_HEXAHEDRON, 20, { Shape::Hexahedron, kCollapsed, { 2, 2, 2 } } },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, { Shape::Hexahedron, kCollapsed, { 2, 2, 2 } } },
  { VTK_TRIQUADRATIC_HEXAHEDRON, 27, { Shape::Hexahedron, kCollapsed, { 2, 2, 2 } } },
  { VTK_WEDGE, 6, { Shape::Prism, kCollapsed, { 1, 1, 1 } } },
  { VTK_QUADRATIC_LINEAR_WEDGE, 12, { Shape::Prism, kCollapsed, { 2, 1, 2 } } },
  { VTK_QUADRATIC_WEDGE, 15, { Shape::Prism, kCollapsed, { 2, 2, 2 } } },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, { Shape::Prism, kCollapsed, { 2, 2, 2 } } },
  { VTK_PYRAMID, 5, { Shape::Pyramid, kCollapsed, { 1, 1, 1 } } },
  { VTK_QUADRATIC_PYRAMID, 13, { Shape::Pyramid, Form::Tensor, { 2, 2, 2 } } },
  // Its bubbles take a third degree towards the apex.
  { VTK_TRIQUADRATIC_PYRAMID, 19, { Shape::Pyramid, Form::Tensor, { 2, 2, 3 } } },
};

const FixedCell* Find(int type)
{
  const auto* found = std::ranges::find(kFixedCells, type, &FixedCell::type);
  return found == std::end(kFixedCells) ? nullptr : found;
}

/// VTK's cells of fixed order: linear, quadratic and their relatives. False: not such a type.
bool IsFixedCell(int type)
{
  return Find(type) != nullptr;
}

CellBasis MakeFixedCellBasis(const CellKind& kind)
{
  const FixedCell& cell = *Find(kind.type);
  if (kind.points != cell.points)
  {
    throw InvalidData(CellTypeName(kind.type) + " needs " + std::to_string(cell.points) +
      " points, not " + std::to_string(kind.points) + "; the file's connectivity is damaged.");
  }
  CellBasis basis{ kind, SampleCell(kind, cell.space), {} };
  if (cell.space.form == Form::Tensor)
  {
    const FixedCell& linear = *Find(VTK_PYRAMID);
    const CellKind corners{ linear.type, linear.points, { 0, 0, 0 }, {} };
    basis.straight = { SampleCell(corners, cell.space), SampleCell(corners, linear.space) };
  }
  return basis;
}

// VTK evaluates its functions in double. At parametric coordinates of few bits this is exact (sums
// and products of few bits). The functions are sampled there, on a tensor grid in eta, and
// interpolated in long double, so that the map has no rounding of VTK's.

/// VTK's parametric coordinates of eta.
std::array<double, 3> Parametric(int type, Shape shape, const Vec3& eta)
{
  const auto half = [](double v) { return (1 + v) / 2; };
  if (shape == Shape::Pyramid && type != VTK_TRIQUADRATIC_PYRAMID)
  {
    return { half(eta.x), half(eta.y), half(eta.z) }; // those of the cube
  }
  const Vec3 xi = TensorToReference(shape, eta);
  switch (shape)
  {
    case Shape::Prism:
      return { half(xi.x), half(xi.z), half(-xi.y) };
    case Shape::Pyramid:
    {
      // This one cell has the pyramid itself: |2 r - 1|, |2 s - 1| <= 1 - T, t = (1 + T) / 2.
      const double T = half(eta.z);
      return { half(eta.x * (1 - T)), half(eta.y * (1 - T)), half(T) };
    }
    default:
      return { half(xi.x), half(xi.y), half(xi.z) };
  }
}

/// The inverse of TensorToReference, off collapsed edges and vertices.
LongVec3 TensorOf(Shape shape, const LongVec3& xi)
{
  const auto part = [](long double z, long double width) { return 2 * (1 + z) / width - 1; };
  const long double layer = 1 - xi[2];
  switch (shape)
  {
    case Shape::Hexahedron:
      return xi;
    case Shape::Prism:
      return { part(xi[0], layer), xi[1], xi[2] };
    case Shape::Tetrahedron:
      return { part(xi[0], -(xi[1] + xi[2])), part(xi[1], layer), xi[2] };
    default:
      return { part(xi[0], layer), part(xi[1], layer), xi[2] };
  }
}

/// degree + 1 points of few bits in [-1,1), where nothing is collapsed.
std::vector<long double> FewBitPoints(int degree)
{
  const long double step = degree <= 3 ? 0.5L : 0.25L;
  std::vector<long double> points;
  for (int i = 0; i <= degree; ++i)
  {
    points.push_back(step * i - 1);
  }
  return points;
}

/// A cell's functions, interpolated from samples.
class SampledFunctions
{
public:
  SampledFunctions(const CellKind& kind, const Space& space)
    : shape_(space.shape)
    , Functions(kind.points)
  {
    const auto degree = space.TensorDegree();
    std::array<std::vector<long double>, 3> points;
    for (int d = 0; d < 3; ++d)
    {
      points[d] = FewBitPoints(degree[d]);
      Lines[d] = Lagrange(points[d]);
    }
    const auto cell = MakeCell(kind);
    std::vector<double> weights(kind.points);
    for (const long double x : points[0])
    {
      for (const long double y : points[1])
      {
        for (const long double z : points[2])
        {
          const Vec3 eta(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
          const auto at = Parametric(kind.type, shape_, eta);
          cell->InterpolateFunctions(at.data(), weights.data());
          Samples.insert(Samples.end(), weights.begin(), weights.end());
        }
      }
    }
  }

  void operator()(const LongVec3& xi, long double* values) const
  {
    const LongVec3 eta = TensorOf(shape_, xi);
    std::array<std::vector<long double>, 3> line;
    for (int d = 0; d < 3; ++d)
    {
      line[d].resize(Lines[d].count);
      Lines[d].evaluate(eta[d], line[d].data());
    }
    std::fill_n(values, Functions, 0.0L);
    const double* sample = Samples.data();
    for (const long double x : line[0])
    {
      for (const long double y : line[1])
      {
        for (const long double z : line[2])
        {
          for (int f = 0; f < Functions; ++f)
          {
            values[f] += x * y * z * *sample++;
          }
        }
      }
    }
  }

private:
  Shape shape_;
  int Functions;
  std::array<LineFunctions, 3> Lines;
  std::vector<double> Samples; ///< all functions at a point, eta3 fastest
};
} // namespace

std::string CellTypeName(int type)
{
  // VTK defines these two types, but has no classes for them.
  if (type == VTK_LAGRANGE_PYRAMID || type == VTK_BEZIER_PYRAMID)
  {
    return type == VTK_LAGRANGE_PYRAMID ? "VTK_LAGRANGE_PYRAMID" : "VTK_BEZIER_PYRAMID";
  }
  const auto cell = Instantiate(type);
  return cell ? cell->GetClassName() : "cell type " + std::to_string(type);
}

int CellDimension(int type)
{
  const auto cell = Instantiate(type);
  return cell ? cell->GetCellDimension() : -1;
}

CellBasis MakeCellBasis(const CellKind& kind)
{
  if (IsFixedCell(kind.type))
  {
    return MakeFixedCellBasis(kind);
  }
  if (IsHigherOrderPlaneCell(kind.type))
  {
    return MakeHigherOrderPlaneCellBasis(kind);
  }
  if (IsHigherOrderCell(kind.type))
  {
    return MakeHigherOrderCellBasis(kind);
  }
  throw Unsupported(CellTypeName(kind.type) +
    " is not supported: it is no polynomial on a tetrahedron, hexahedron, wedge or pyramid, "
    "triangle "
    "or quadrilateral whose nodes VTK defines; take out such cells (vtkExtractCells) or split "
    "them.");
}

vtkSmartPointer<vtkCell> MakeCell(const CellKind& kind)
{
  auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(kind.type));
  cell->GetPoints()->SetNumberOfPoints(kind.points);
  cell->GetPointIds()->SetNumberOfIds(kind.points);
  for (int i = 0; i < kind.points; ++i)
  {
    cell->GetPoints()->SetPoint(i, 0.0, 0.0, 0.0);
    cell->GetPointIds()->SetId(i, i);
  }
  const auto& n = kind.degrees;
  const bool uniform = n == std::array{ 0, 0, 0 } || kind.points == 21; // the wedge with bubbles
  if (auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell))
  {
    uniform ? wedge->SetUniformOrderFromNumPoints(kind.points)
            : wedge->SetOrder(n[0], n[1], n[2], kind.points);
  }
  else if (auto* hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
  {
    uniform ? hexahedron->SetUniformOrderFromNumPoints(kind.points)
            : hexahedron->SetOrder(n[0], n[1], n[2]);
  }
  else if (auto* quadrilateral = vtkHigherOrderQuadrilateral::SafeDownCast(cell))
  {
    uniform ? quadrilateral->SetUniformOrderFromNumPoints(kind.points)
            : quadrilateral->SetOrder(n[0], n[1]);
  }
  if (cell->RequiresInitialization())
  {
    cell->Initialize();
  }
  return cell;
}

ChangeOfBasis SampleCell(const CellKind& kind, const Space& space)
{
  return ChangeOfBasis::FromFunctions(space, kind.points, SampledFunctions(kind, space));
}
} // namespace pixelexact
