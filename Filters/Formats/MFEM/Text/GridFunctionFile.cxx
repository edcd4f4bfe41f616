// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Text/GridFunctionFile.h"

#include "Core/Basis/Space.h"
#include "Formats/MFEM/Text/QuadratureFile.h"

#include <algorithm>
#include <cmath>

namespace pixelexact::mfem
{
namespace
{
constexpr std::size_t kDefaultBytes = 16;

std::vector<double> ReadNumbers(TextScanner& scanner)
{
  std::vector<double> numbers;
  double number = 0.0;
  while (scanner.TryNumber(number))
  {
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<int> ReadAttributes(TextScanner& scanner)
{
  std::vector<int> list(
    static_cast<std::size_t>(scanner.Count("the number of boundaries that are identified", 2)));
  std::ranges::generate(list, [&] { return scanner.Integer("a boundary that is identified"); });
  return list;
}

/// Reads the sections of a version 1.0 header.
void ReadSections(TextScanner& scanner, GridFunctionFile& file)
{
  while (scanner.Peek().starts_with("NURBS_"))
  {
    const std::string_view section = scanner.Word("a section");
    NurbsSections& nurbs = file.nurbs ? *file.nurbs : file.nurbs.emplace();
    if (section == "NURBS_order" || section == "NURBS_orders")
    {
      for (const double order : ReadNumbers(scanner))
      {
        if (!(order >= 1 && order <= kMaxOrder) || order != std::floor(order))
        {
          scanner.FailUnsupported(
            "a NURBS space has an order that is none from 1 to " + std::to_string(kMaxOrder) + ".");
        }
        nurbs.orders.push_back(static_cast<int>(order));
      }
    }
    else if (section == "NURBS_periodic")
    {
      nurbs.masters = ReadAttributes(scanner);
      nurbs.slaves = ReadAttributes(scanner);
    }
    else if (section == "NURBS_weights")
    {
      nurbs.weights = ReadNumbers(scanner);
    }
    else
    {
      scanner.FailUnsupported("the section '" + std::string(section.substr(0, 40)) +
        "' of a space is not read; save the grid function with MFEM 4.");
    }
  }
  scanner.Expect("End:");
  scanner.Expect("MFEM");
  scanner.Expect("FiniteElementSpace");
  scanner.Expect("v1.0");
}

bool IsComplex(TextScanner& scanner)
{
  // A piece of a process and a whole file have different words.
  return scanner.Peek() == "ComplexGridFunction" || scanner.Peek() == "ParComplexGridFunction";
}
} // namespace

GridFunctionFile ReadGridFunction(TextScanner& scanner)
{
  if (IsComplex(scanner))
  {
    scanner.FailUnsupported(
      "the mesh's nodes are a complex grid function, and should be a real one.");
  }
  return ReadAnyGridFunction(scanner);
}

GridFunctionFile ReadAnyGridFunction(TextScanner& scanner)
{
  if (IsQuadratureFunction(scanner))
  {
    return ReadQuadratureFunction(scanner);
  }
  GridFunctionFile file;
  file.isComplex = IsComplex(scanner);
  if (file.isComplex)
  {
    scanner.Word("the kind of the grid function");
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
  file.components = scanner.Integer("the number of components (VDim)", 1, kMaxComponents);
  scanner.Expect("Ordering:");
  file.byNodes = scanner.Integer("the ordering", 0, 1) == 0;
  if (hasSections)
  {
    ReadSections(scanner, file);
  }
  if (file.IsNurbs() && scanner.Peek() == "NURBS_patches")
  {
    scanner.Word("the patches");
    file.byPatches = true;
    if (file.isComplex)
    {
      scanner.FailUnsupported(
        "complex grid functions by patches are not read, as by MFEM; save them "
        "without NURBS_patches.");
    }
  }
  // A number takes about 20 bytes. Where numbers are shorter, the list grows.
  file.values.reserve(scanner.Remaining() / kDefaultBytes);
  double value = 0.0;
  while (scanner.TryNumber(value))
  {
    file.values.push_back(value);
  }
  if (file.isComplex && file.values.size() % 2 != 0)
  {
    scanner.Fail("a complex grid function holds " + std::to_string(file.values.size()) +
      " numbers, and should hold as many real as imaginary parts; the file is cut short.");
  }
  return file;
}

std::pair<GridFunctionFile, GridFunctionFile> PartsOf(const GridFunctionFile& complex)
{
  GridFunctionFile real;
  real.collection = complex.collection;
  real.components = complex.components;
  real.byNodes = complex.byNodes;
  real.nurbs = complex.nurbs;
  GridFunctionFile imaginary = real;
  const auto middle =
    complex.values.begin() + static_cast<std::ptrdiff_t>(complex.values.size() / 2);
  real.values.assign(complex.values.begin(), middle);
  imaginary.values.assign(middle, complex.values.end());
  return { std::move(real), std::move(imaginary) };
}
} // namespace pixelexact::mfem
