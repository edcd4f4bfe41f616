// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace pixelexact
{
/// An error that a user can cause: a bad file, a missing field, an impossible request. The message
/// names the thing and the remedy. The VTK classes turn it into vtkErrorMacro, the tool into exit
/// status 1.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The input's arrays contradict each other or hold what no mesh can hold (NaN coordinates, wrong
/// sizes).
class InvalidData : public Error
{
public:
  using Error::Error;
};

/// The input is sound, but of a kind that is not supported.
class Unsupported : public Error
{
public:
  using Error::Error;
};

/// The coefficients no longer belong to the points and cells of the grid.
class StaleData : public Error
{
public:
  using Error::Error;
};
} // namespace pixelexact
