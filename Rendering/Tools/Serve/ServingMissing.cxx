// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/Serving.h"

#include "Picture/RenderOptions.h"

#include "Core/Base/Error.h"

namespace pixelexact
{
void Serve(RenderOptions /*options*/, const ServingOptions& /*serving*/,
  const std::vector<std::string>& /*words*/)
{
  throw Error("serve: this program was built without the page; install libwebsockets-dev and build "
              "with cmake --preset release, or use render");
}
} // namespace pixelexact
