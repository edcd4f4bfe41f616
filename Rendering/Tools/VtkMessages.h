// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkOutputWindow;

namespace pixelexact
{
/// While it lives, what VTK would print is kept instead: the tool says each failure once, in its
/// own words, and the pages that VTK prints about it stay away from the user. Not nested, one
/// thread.
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// The first error, without the file name and line of VTK's sources; empty: none.
  [[nodiscard]] std::string FirstError() const;
  /// The first warning, in the same way.
  [[nodiscard]] std::string FirstWarning() const;

private:
  vtkSmartPointer<vtkOutputWindow> Before;
  vtkSmartPointer<vtkOutputWindow> Recorder;
};
} // namespace pixelexact
