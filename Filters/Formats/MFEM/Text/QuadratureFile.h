// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Text/GridFunctionFile.h"

#include "Core/Base/Error.h"

#include <string>

// Quadrature functions: values at the points of a quadrature rule. On quadrilaterals and hexahedra
// the rule is that of Gauss and Legendre, with the same number of points in each direction. The
// polynomial through the values is then a grid function of L2 with nodes at these points, whose
// unknowns are the values in the file's order.
namespace pixelexact::mfem
{
/// The shape's points do not determine a polynomial.
class UnreadQuadrature final : public Unsupported
{
public:
  using Unsupported::Unsupported;
};

/// Whether a quadrature function begins here.
[[nodiscard]] bool IsQuadratureFunction(TextScanner& scanner);

/// Reads the header and all numbers after it. Throws Unsupported for quadrature functions on faces.
[[nodiscard]] GridFunctionFile ReadQuadratureFunction(TextScanner& scanner);

/// The name of a grid function's collection on elements of a dimension, also of a quadrature
/// function.
[[nodiscard]] std::string CollectionOf(const GridFunctionFile& file, int dimension);

/// Throws UnreadQuadrature for a quadrature function where `areRead` is false: on other shapes than
/// quadrilaterals and hexahedra, and on NURBS, whose elements may be divided. `name`: of its file.
void RequirePoints(const GridFunctionFile& file, bool areRead, const std::string& name);

/// What a quadrature function is, for people: "values at 4 Gauss-Legendre points in each
/// direction".
[[nodiscard]] std::string DescribeQuadrature(const GridFunctionFile& file);
} // namespace pixelexact::mfem
