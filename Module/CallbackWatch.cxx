// SPDX-License-Identifier: BSD-3-Clause
#include "CallbackWatch.h"

namespace pixelexact
{
namespace
{
thread_local CallbackWatch* latest = nullptr;
} // namespace

CallbackWatch::CallbackWatch()
  : Before(latest)
{
  latest = this;
}

CallbackWatch::~CallbackWatch()
{
  latest = Before;
}

CallbackWatch* CallbackWatch::Current()
{
  return latest;
}
} // namespace pixelexact
