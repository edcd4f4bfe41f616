// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactDataModelModule.h"

#include <string>

namespace pixelexact
{
/// While an object of this class lives, it collects the errors of vtkImplicitCallbacks that this
/// thread evaluates; otherwise they report errors themselves. After the first error they are NaN
/// without an evaluation.
class PIXELEXACTDATAMODEL_EXPORT CallbackWatch
{
public:
  CallbackWatch();
  ~CallbackWatch();
  CallbackWatch(const CallbackWatch&) = delete;
  CallbackWatch& operator=(const CallbackWatch&) = delete;

  /// The latest object of this thread; null: there is none.
  static CallbackWatch* Current();

  std::string failure; ///< empty: none

private:
  CallbackWatch* Before;
};
} // namespace pixelexact
