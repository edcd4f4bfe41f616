// SPDX-License-Identifier: BSD-3-Clause
// Format: QuadratureSpace::Save and QuadratureFunction::Save of MFEM 4.
#include "Formats/MFEM/Text/QuadratureFile.h"

#include <string_view>

namespace pixelexact::mfem
{
namespace
{
constexpr int kMaxQuadratureOrder = 1 << 10;
constexpr std::string_view kOnElements = "QuadratureSpace";
constexpr std::string_view kFacePoints = "FaceQuadratureSpace";

/// The Gauss-Legendre points in a direction with which polynomials of this order are integrated
/// exactly.
int PointsOf(int order)
{
  return order / 2 + 1;
}
} // namespace

bool IsQuadratureFunction(TextScanner& scanner)
{
  return scanner.Peek() == kOnElements || scanner.Peek() == kFacePoints;
}

GridFunctionFile ReadQuadratureFunction(TextScanner& scanner)
{
  if (scanner.Peek() == kFacePoints)
  {
    scanner.FailUnsupported("quadrature functions on faces are not read; project the function to "
                            "L2 and save that.");
  }
  GridFunctionFile file;
  scanner.Expect(kOnElements);
  scanner.Expect("Type:");
  scanner.Expect("default_quadrature");
  scanner.Expect("Order:");
  const int order = scanner.Integer("the order of the quadrature rule", 0, kMaxQuadratureOrder);
  file.quadraturePoints = PointsOf(order);
  file.collection = std::string(kOnElements) + " of order " + std::to_string(order);
  scanner.Expect("VDim:");
  file.components = scanner.Integer("the number of components (VDim)", 1, kMaxComponents);
  file.byNodes = false;
  double value = 0.0;
  while (scanner.TryNumber(value))
  {
    file.values.push_back(value);
  }
  return file;
}

std::string CollectionOf(const GridFunctionFile& file, int dimension)
{
  return file.quadraturePoints == 0
    ? file.collection
    : "L2_" + std::to_string(dimension) + "D_P" + std::to_string(file.quadraturePoints - 1);
}

void RequirePoints(const GridFunctionFile& file, bool areRead, const std::string& name)
{
  if (file.quadraturePoints != 0 && !areRead)
  {
    throw UnreadQuadrature(name +
      ": quadrature functions are read on quadrilaterals and hexahedra that are no NURBS, and the "
      "mesh has other elements; project the function to L2 and save that.");
  }
}

std::string DescribeQuadrature(const GridFunctionFile& file)
{
  const int points = file.quadraturePoints;
  return "values at " + std::to_string(points) +
    (points == 1 ? " Gauss-Legendre point" : " Gauss-Legendre points in each direction");
}
} // namespace pixelexact::mfem
