// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/GridFunctionFile.h"

namespace pixelexact::mfem
{
namespace
{
constexpr std::size_t kUsualBytes = 16;
constexpr int kMostComponents = 1 << 16;

/// The sections of a version 1.0 header.
void ReadSections(TextScanner& scanner)
{
  scanner.Expect("End:");
  scanner.Expect("MFEM");
  scanner.Expect("FiniteElementSpace");
  scanner.Expect("v1.0");
}
} // namespace

GridFunctionFile ReadGridFunction(TextScanner& scanner)
{
  GridFunctionFile file;
  if (scanner.Peek() == "QuadratureSpace")
  {
    scanner.FailUnsupported(
      "quadrature functions, which have values at points of their own, are not "
      "read; project the function to L2 and save that.");
  }
  if (scanner.Peek() == "ComplexGridFunction")
  {
    scanner.FailUnsupported(
      "complex grid functions are not read; save their real and imaginary parts.");
  }
  const bool hasSections = scanner.Peek() == "MFEM";
  if (hasSections)
  {
    scanner.Expect("MFEM");
  }
  scanner.Expect("FiniteElementSpace");
  if (hasSections)
  {
    scanner.Expect("v1.0");
  }
  scanner.Expect("FiniteElementCollection:");
  file.collection = scanner.RestOfLine();
  scanner.Expect("VDim:");
  file.components = scanner.Integer("the number of components (VDim)", 1, kMostComponents);
  scanner.Expect("Ordering:");
  file.byNodes = scanner.Integer("the ordering", 0, 1) == 0;
  if (hasSections)
  {
    if (scanner.Peek().starts_with("NURBS"))
    {
      scanner.FailUnsupported("NURBS spaces are not read; project the grid function onto an H1 or "
                              "L2 space in MFEM and save that.");
    }
    ReadSections(scanner);
  }
  // A number takes some 20 bytes, or, where it is short, the list grows as it goes.
  file.values.reserve(scanner.Remaining() / kUsualBytes);
  double value = 0.0;
  while (scanner.TryNumber(value))
  {
    file.values.push_back(value);
  }
  return file;
}
} // namespace pixelexact::mfem
