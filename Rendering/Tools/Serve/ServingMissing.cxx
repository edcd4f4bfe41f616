// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/Serving.h"

#include "Picture/RenderOptions.h"

#include "Core/Base/Error.h"

namespace pixelexact
{
void Serve(RenderOptions /*options*/, const ServingOptions& /*serving*/,
  const std::vector<std::string>& /*words*/)
{
  throw Error("serve: this program was built without libwebsockets; install libwebsockets-dev and "
              "build it, or use render or view");
}
} // namespace pixelexact
