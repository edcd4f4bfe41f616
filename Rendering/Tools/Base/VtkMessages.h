// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

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
  /// The first that VTK's functions without an object warn of, in the same way: its legacy reader's
  /// of data that they could not read.
  [[nodiscard]] std::string FirstGenericWarning() const;
  /// Other warnings, each once.
  [[nodiscard]] std::vector<std::string> Warnings() const;

private:
  vtkSmartPointer<vtkOutputWindow> Before;
  vtkSmartPointer<vtkOutputWindow> Recorder;
};
} // namespace pixelexact
