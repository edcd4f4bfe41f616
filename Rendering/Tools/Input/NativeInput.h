// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Input.h"

// The solvers' own formats, for FormatTable.cxx. They throw as ReadInput.
namespace pixelexact
{
/// x.mesh [u.gf ...], x.000000 [u.000000 ...]
InputGrid ReadMfemFiles(const InputRequest& request);
/// x_000000.mfem_root [x_000010.mfem_root ...], which are time steps.
InputGrid ReadMfemCollection(const InputRequest& request);
/// x.saved
InputGrid ReadGlvisFile(const InputRequest& request);
/// x.msh [views.msh ...]
InputGrid ReadGmshFiles(const InputRequest& request);
/// x.xml [more.xml x.nekg ...] [u.fld ...]; several field files are time steps.
InputGrid ReadNektarFiles(const InputRequest& request);
/// x.nek5000, or x0.f00000 [x0.f00001 ...], which are time steps.
InputGrid ReadNekFiles(const InputRequest& request);
/// x_State_*.h5 [...], which are time steps, or x_mesh.h5 [x_State_*.h5 ...]
InputGrid ReadFlexiFiles(const InputRequest& request);
/// A field file in the first place.
InputGrid RefuseFieldFile(const InputRequest& request);
} // namespace pixelexact
