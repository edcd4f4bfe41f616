// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Text/TextScanner.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pixelexact::mfem
{
/// The sections of a NURBS space's header where the space differs from the mesh's.
struct NurbsSections
{
  std::vector<int> orders; ///< one for all knot vectors, or one for each
  std::vector<int> masters;
  std::vector<int> slaves;
  std::vector<double> weights; ///< per control point; empty: all are 1
};

/// The largest number of components (VDim) that is read.
inline constexpr int kMaxComponents = 1 << 16;

/// The contents of a grid function's file.
struct GridFunctionFile
{
  std::string collection;
  int components = 1;  ///< VDim
  bool byNodes = true; ///< Ordering 0: component by component; 1: unknown by unknown
  std::vector<double> values;
  std::optional<NurbsSections> nurbs;
  bool byPatches = false; ///< NURBS: the values of each patch's control points, one after the other
  int quadraturePoints = 0; ///< in each direction, of a quadrature function; 0: it is none
  bool isComplex = false;   ///< the real parts of all unknowns, then the imaginary ones

  [[nodiscard]] bool IsNurbs() const { return collection.starts_with("NURBS"); }
};

/// Reads a header and all numbers after it. Throws Unsupported for a complex grid function.
GridFunctionFile ReadGridFunction(TextScanner& scanner);
/// The same for a grid function that may be complex, or a quadrature function.
GridFunctionFile ReadAnyGridFunction(TextScanner& scanner);

/// The real and the imaginary part of a complex grid function.
std::pair<GridFunctionFile, GridFunctionFile> PartsOf(const GridFunctionFile& complex);
} // namespace pixelexact::mfem
