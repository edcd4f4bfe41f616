// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>

#include <string>

class vtkLookupTable;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

namespace pixelexact
{
/// What a window tells over its picture: a line of what is there, the keys, the colours' bar.
class ViewTexts
{
public:
  ViewTexts();
  ~ViewTexts();
  ViewTexts(const ViewTexts&) = delete;
  ViewTexts& operator=(const ViewTexts&) = delete;

  /// `table` null: there is no bar.
  void AddTo(vtkRenderer& renderer, vtkLookupTable* table, const std::string& field);
  void Tell(const std::string& text);
  /// The help, or the key that shows it.
  void TurnHelp();
  void SetTable(vtkLookupTable* table);

private:
  void ShowHelp();

  bool Help = false;
  vtkNew<vtkScalarBarActor> Bar;
  vtkNew<vtkTextActor> Status;
  vtkNew<vtkTextActor> HelpText;
};
} // namespace pixelexact
