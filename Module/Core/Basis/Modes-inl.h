// SPDX-License-Identifier: BSD-3-Clause
// Value and gradient of a modal sum by sum factorisation (paper, equation 10), for any number type:
// Lanes in the kernels, FloatLanes in single precision, long double in the changes of basis. All
// classes have HexahedronModes' interface.
#if defined(PIXELEXACT_MODES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_MODES_INL_H
#undef PIXELEXACT_MODES_INL_H
#else
#define PIXELEXACT_MODES_INL_H
#endif

#include "Core/Basis/HexahedronModes-inl.h"
#include "Core/Basis/PrismModes-inl.h"
#include "Core/Basis/PyramidModes-inl.h"
#include "Core/Basis/TetrahedronModes-inl.h"

#endif
