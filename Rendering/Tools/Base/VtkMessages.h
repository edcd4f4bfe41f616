// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkObject;
class vtkOutputWindow;

namespace pixelexact
{
/// Collects VTK's messages during its lifetime instead of printing them, so that the tool reports
/// each failure once, in its own words. Must not be nested; for one thread.
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

/// Collects the errors of one VTK object, as a writer, during its lifetime instead of printing
/// them. Several may exist at once, on any threads.
class ErrorsOfObject
{
public:
  explicit ErrorsOfObject(vtkObject& object);
  ~ErrorsOfObject();
  ErrorsOfObject(const ErrorsOfObject&) = delete;
  ErrorsOfObject& operator=(const ErrorsOfObject&) = delete;

  /// The first error, without the file name and line of VTK's sources; empty: none.
  [[nodiscard]] const std::string& First() const { return first_; }

private:
  void Keep(void* text);

  vtkSmartPointer<vtkObject> Object;
  unsigned long Observer;
  std::string first_;
};
} // namespace pixelexact
