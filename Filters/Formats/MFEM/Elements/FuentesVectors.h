// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/VectorSpaces.h"

namespace pixelexact::mfem
{
/// The H(curl) and H(div) spaces on MFEM's unit pyramid that go with FuentesFunctions. Their
/// components are polynomials in tensor coordinates, of degree `order` and `order` + 1.
VectorSpace FuentesCurl(int order);
VectorSpace FuentesDiv(int order);
} // namespace pixelexact::mfem
