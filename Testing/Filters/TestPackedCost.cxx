// SPDX-License-Identifier: BSD-3-Clause
// What packing costs in time and memory; printed, not judged.
#include "Support.h"

#include "HighOrderArrays.h"
#include "PackedArrays.h"
#include "vtkMFEMReader.h"
#include "vtkNektarReader.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

/// MiB of the arrays whose names begin so.
double MebibytesOf(vtkFieldData* data, const std::string& prefix)
{
  double kibibytes = 0.0;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (std::string(data->GetArrayName(i)).starts_with(prefix))
    {
      kibibytes += static_cast<double>(data->GetAbstractArray(i)->GetActualMemorySize());
    }
  }
  return kibibytes / 1024.0;
}

/// The least seconds of three runs.
template <class Work>
double SecondsOf(const Work& work)
{
  double least = 1e300;
  for (int run = 0; run < 3; ++run)
  {
    const auto start = std::chrono::steady_clock::now();
    work();
    least = std::min(
      least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

/// $PIXELEXACT_PACK_FILES: "mesh field;mesh field;...".
TEST(PackedArrays, CostOfFiles)
{
  const char* given = std::getenv("PIXELEXACT_PACK_FILES");
  if (given == nullptr)
  {
    GTEST_SKIP() << "PIXELEXACT_PACK_FILES names no files";
  }
  std::istringstream list(given);
  for (std::string entry; std::getline(list, entry, ';');)
  {
    std::istringstream words(entry);
    std::string mesh;
    std::string field;
    words >> mesh >> field;
    vtkSmartPointer<vtkUnstructuredGrid> grid;
    const auto read = [&](vtkHighOrderFileReader& reader)
    {
      reader.SetFileName(mesh.c_str());
      reader.Update();
      grid = reader.GetOutput();
    };
    if (mesh.ends_with(".xml"))
    {
      vtkNew<vtkNektarReader> reader;
      reader->AddFieldFileName(field.c_str());
      read(*reader);
    }
    else
    {
      vtkNew<vtkMFEMReader> reader;
      reader->AddGridFunctionFileName(field.c_str());
      read(*reader);
    }
    ASSERT_GT(grid->GetNumberOfCells(), 0) << entry;
    vtkSmartPointer<vtkUnstructuredGrid> packed;
    const double packing = SecondsOf([&] { packed = Pack(grid); });
    const double unpacking = SecondsOf([&] { (void)Unpack(packed); });
    const double appending = SecondsOf(
      [&]
      {
        vtkNew<vtkAppendFilter> append;
        append->AddInputData(packed);
        append->AddInputData(packed);
        append->Update();
      });
    std::cout << mesh.substr(mesh.rfind('/') + 1) << ": " << grid->GetNumberOfCells()
              << " cells; FieldData "
              << MebibytesOf(grid->GetFieldData(), kMeshPrefix) +
        MebibytesOf(grid->GetFieldData(), kFieldPrefix)
              << " MiB, packed " << MebibytesOf(packed->GetCellData(), kPackedPrefix)
              << " MiB; pack " << packing << " s, unpack " << unpacking
              << " s, vtkAppendFilter of two " << appending << " s\n";
  }
}
} // namespace
