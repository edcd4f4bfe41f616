// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactDataModelModule.h"

#include <string>

namespace pixelexact
{
/// While it lives, hears what the vtkImplicitCallbacks that this thread asks have to complain of;
/// else they say it themselves. From the first complaint on they ask nobody and are NaN.
class PIXELEXACTDATAMODEL_EXPORT CallbackWatch
{
public:
  CallbackWatch();
  ~CallbackWatch();
  CallbackWatch(const CallbackWatch&) = delete;
  CallbackWatch& operator=(const CallbackWatch&) = delete;

  /// The latest of this thread; null: nobody listens.
  static CallbackWatch* Current();

  std::string failure; ///< empty: none

private:
  CallbackWatch* Before;
};
} // namespace pixelexact
