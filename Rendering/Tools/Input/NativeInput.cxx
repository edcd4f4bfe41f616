// SPDX-License-Identifier: BSD-3-Clause
#include "Input/NativeInput.h"

#include "Base/Command.h"
#include "Base/Processes.h"
#include "Base/VtkMessages.h"

#include "Core/Base/Error.h"
#include "Files/TimeSeries.h"
#include "Formats/MFEM/Text/PieceNames.h"
#include "vtkFlexiReader.h"
#include "vtkGLVisReader.h"
#include "vtkGmshReader.h"
#include "vtkHighOrderGrid.h"
#include "vtkMFEMReader.h"
#include "vtkNekReader.h"
#include "vtkNektarReader.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <filesystem>
#include <set>

namespace pixelexact
{
namespace
{
InputGrid ReadWith(vtkHighOrderFileReader& reader, const InputRequest& request)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const VtkMessages messages;
  const auto check = [&]
  {
    // The reader's own message names the file.
    if (const std::string error = messages.FirstError(); !error.empty())
    {
      throw Error(error);
    }
  };
  if (request.surfaceElements && vtkGmshReader::SafeDownCast(&reader) == nullptr)
  {
    CannotRead(request.files[0],
      "files of its format hold elements of one kind; leave out --surface-elements (--boundary "
      "shows the boundary of solids)");
  }
  InputGrid input;
  reader.SetFileName(request.files[0].c_str());
  reader.SetCells(request.cornerCells ? vtkHighOrderFileReader::CORNER_CELLS
                                      : vtkHighOrderFileReader::LAGRANGE_CELLS);
  reader.UpdateInformation();
  check();
  vtkInformation* information = reader.GetOutputInformation(0);
  if (information->Has(Pipeline::TIME_STEPS()))
  {
    const double* times = information->Get(Pipeline::TIME_STEPS());
    input.times.assign(times, times + information->Length(Pipeline::TIME_STEPS()));
  }
  input.step = ChooseStep(request, input.times);
  if (request.timesAlone)
  {
    return input;
  }
  vtkNew<vtkCallbackCommand> onProgress;
  onProgress->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void* part)
    {
      if (!ReadListener::Report(*static_cast<double*>(part)))
      {
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    });
  reader.AddObserver(vtkCommand::ProgressEvent, onProgress);
  const PieceOf part = PartOfThisProcess();
  if (input.times.empty())
  {
    reader.UpdatePiece(part.piece, part.count, 0);
  }
  else
  {
    reader.UpdateTimeStep(
      input.times[static_cast<std::size_t>(input.step)], part.piece, part.count, 0);
  }
  check();
  input.grid = reader.GetOutput();
  for (int i = 0; i < reader.GetNumberOfDiagnostics(); ++i)
  {
    input.notes.push_back(reader.GetDiagnostic(i));
  }
  return input;
}
/// The name that the pieces of a mesh or a grid function share.
std::string WithoutPiece(const std::string& file)
{
  return mfem::IsPieceName(file) ? std::filesystem::path(file).replace_extension(".*").string()
                                 : file;
}
} // namespace

InputGrid ReadMfemFiles(const InputRequest& request)
{
  vtkNew<vtkMFEMReader> reader;
  std::set<std::string> known{ WithoutPiece(request.files[0]) };
  for (std::size_t i = 1; i < request.files.size(); ++i)
  {
    // One piece of x.* represents all pieces.
    if (known.insert(WithoutPiece(request.files[i])).second)
    {
      reader->AddGridFunctionFileName(request.files[i].c_str());
    }
  }
  return ReadWith(*reader, request);
}

InputGrid ReadMfemCollection(const InputRequest& request)
{
  vtkNew<vtkMFEMReader> reader;
  for (std::size_t i = 1; i < request.files.size(); ++i)
  {
    reader->AddStepFileName(request.files[i].c_str());
  }
  return ReadWith(*reader, request);
}

InputGrid ReadGlvisFile(const InputRequest& request)
{
  CheckAlone(request.files);
  vtkNew<vtkGLVisReader> reader;
  return ReadWith(*reader, request);
}

InputGrid ReadGmshFiles(const InputRequest& request)
{
  vtkNew<vtkGmshReader> reader;
  reader->SetSurfaceElements(request.surfaceElements);
  for (std::size_t i = 1; i < request.files.size(); ++i)
  {
    reader->AddViewFileName(request.files[i].c_str());
  }
  return ReadWith(*reader, request);
}

InputGrid ReadNektarFiles(const InputRequest& request)
{
  vtkNew<vtkNektarReader> reader;
  for (std::size_t i = 1; i < request.files.size(); ++i)
  {
    const std::string& file = request.files[i];
    if (IsMeshSuffix(LowerSuffix(file)))
    {
      reader->AddSessionFileName(file.c_str());
    }
    else
    {
      reader->AddFieldFileName(file.c_str());
    }
  }
  return ReadWith(*reader, request);
}

InputGrid ReadNekFiles(const InputRequest& request)
{
  vtkNew<vtkNekReader> reader;
  for (std::size_t i = 1; i < request.files.size(); ++i)
  {
    reader->AddStepFileName(request.files[i].c_str());
  }
  return ReadWith(*reader, request);
}

InputGrid ReadFlexiFiles(const InputRequest& request)
{
  vtkNew<vtkFlexiReader> reader;
  for (std::size_t i = 1; i < request.files.size(); ++i)
  {
    reader->AddStateFileName(request.files[i].c_str());
  }
  return ReadWith(*reader, request);
}

InputGrid RefuseFieldFile(const InputRequest& request)
{
  throw UsageError("'" + request.files[0] +
    "' holds a field without its mesh; name the mesh file before it (x.mesh u.gf, x.xml u.fld)");
}
} // namespace pixelexact
