// SPDX-License-Identifier: BSD-3-Clause
#include "BlockInput.h"

#include "VtkMessages.h"

#include <vtkCGNSReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <string_view>

namespace pixelexact
{
InputGrid ReadCgnsFile(const InputRequest& request)
{
  CheckAlone(request.files);
  const std::string& file = request.files[0];
  // Most writers of ADF set the high bit of the first four characters.
  constexpr std::array<std::string_view, 3> kMarks{ kHdf5Mark, "@(#)ADF Database",
    "\xC0\xA8\xA3\xA9"
    "ADF Database" };
  RequireMark(file, kMarks, "CGNS file (HDF5 or ADF)");
  const VtkMessages messages;
  const auto check = [&]
  {
    if (const std::string error = messages.FirstError(); !error.empty())
    {
      CannotRead(file, error);
    }
  };
  vtkNew<vtkCGNSReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetLoadBndPatch(false);
  reader->SetDoublePrecisionMesh(1);
  reader->UpdateInformation();
  check();
  reader->EnableAllBases();
  reader->EnableAllFamilies();
  reader->EnableAllPointArrays();
  reader->EnableAllCellArrays();
  InputGrid input;
  UpdateToStep(*reader, request, input);
  check();
  input.grid = JoinBlocks(
    *vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0)), file, input.notes);
  return input;
}
} // namespace pixelexact
