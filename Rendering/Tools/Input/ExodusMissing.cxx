// SPDX-License-Identifier: BSD-3-Clause
#include "Input/BlockInput.h"

namespace pixelexact
{
InputGrid ReadExodusFile(const InputRequest& request)
{
  CannotRead(request.files[0],
    "the VTK that this program was built with has no reader of Exodus II; convert it to .vtu");
}
} // namespace pixelexact
