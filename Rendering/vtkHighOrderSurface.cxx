// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderSurface.h"

//------------------------------------------------------------------------------
vtkHighOrderSurface::vtkHighOrderSurface() = default;

//------------------------------------------------------------------------------
vtkHighOrderSurface::~vtkHighOrderSurface() = default;

//------------------------------------------------------------------------------
void vtkHighOrderSurface::Update() {}
