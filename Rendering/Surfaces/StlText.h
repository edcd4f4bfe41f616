// SPDX-License-Identifier: BSD-3-Clause
#ifndef StlText_h
#define StlText_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace pixelexact
{
/// The triangles of an .stl file of text, with the doubles that it spells; VTK's reader rounds them
/// to floats. Null: the file is a binary one, whose numbers are floats. Throws InvalidData, which
/// says why, for a text that ends within a triangle or spells no number.
vtkSmartPointer<vtkPolyData> ReadStlText(const std::string& file);
} // namespace pixelexact
#endif
