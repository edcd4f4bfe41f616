// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/TextScanner.h"

#include <string>
#include <vector>

namespace pixelexact::mfem
{
/// A grid function as its file has it.
struct GridFunctionFile
{
  std::string collection;
  int components = 1;  ///< VDim
  bool byNodes = true; ///< Ordering 0: component by component; 1: unknown by unknown
  std::vector<double> values;
};

/// Reads a header and all the numbers that follow it.
GridFunctionFile ReadGridFunction(TextScanner& scanner);
} // namespace pixelexact::mfem
