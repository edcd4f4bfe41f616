// SPDX-License-Identifier: BSD-3-Clause
#ifndef StlText_h
#define StlText_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace pixelexact
{
/// The triangles of an ASCII .stl file, read as doubles; VTK's reader rounds them to floats. Null
/// for a binary file, which stores floats. Throws InvalidData, with the reason, for a text that
/// ends inside a triangle or has an invalid number.
vtkSmartPointer<vtkPolyData> ReadStlText(const std::string& file);
} // namespace pixelexact
#endif
