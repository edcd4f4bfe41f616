// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMFEMReader.h"

#include "Core/Base/Error.h"
#include "Formats/FileText.h"
#include "Formats/MFEM/Reader.h"
#include "Formats/MFEM/RootFile.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

vtkStandardNewMacro(vtkMFEMReader);

using namespace pixelexact;

namespace
{
bool IsRootFile(const std::string& name)
{
  return std::filesystem::path(name).extension() == ".mfem_root";
}

mfem::RootFile LoadRootFile(const std::string& name)
{
  const std::string text = ReadFileText(name);
  return mfem::ParseRootFile({ name, text });
}
} // namespace

vtkMFEMReader::vtkMFEMReader() = default;
vtkMFEMReader::~vtkMFEMReader() = default;

void vtkMFEMReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& name : this->GridFunctions)
  {
    os << indent << "GridFunction: " << name << "\n";
  }
  for (const auto& name : this->Steps)
  {
    os << indent << "Step: " << name << "\n";
  }
}

void vtkMFEMReader::AddGridFunctionFileName(const char* name)
{
  this->GridFunctions.emplace_back(name ? name : "");
  this->Modified();
}

void vtkMFEMReader::ClearGridFunctionFileNames()
{
  this->GridFunctions.clear();
  this->Modified();
}

void vtkMFEMReader::AddStepFileName(const char* name)
{
  this->Steps.emplace_back(name ? name : "");
  this->Modified();
}

void vtkMFEMReader::ClearStepFileNames()
{
  this->Steps.clear();
  this->Modified();
}

std::vector<double> vtkMFEMReader::ReadTimes()
{
  this->Order.clear();
  if (!IsRootFile(this->FileName))
  {
    return {};
  }
  std::vector<std::string> files{ this->FileName };
  files.insert(files.end(), this->Steps.begin(), this->Steps.end());
  std::map<double, std::string> byTime;
  for (const auto& file : files)
  {
    const double time = LoadRootFile(file).time;
    const auto [at, isNew] = byTime.try_emplace(time, file);
    if (!isNew)
    {
      throw InvalidData(file + " and " + at->second + " are of one time, " + std::to_string(time) +
        "; name one of them.");
    }
  }
  std::vector<double> times;
  for (const auto& [time, file] : byTime)
  {
    times.push_back(time);
    this->Order.push_back(file);
  }
  return times;
}

bool vtkMFEMReader::IsHead(const std::string& head)
{
  std::istringstream words(head);
  std::string first;
  std::string second;
  words >> first >> second;
  return (first == "MFEM" && second != "FiniteElementSpace") ||
    (first.starts_with('{') && head.find("\"dsets\"") != std::string::npos); // a root file
}

SolverModel vtkMFEMReader::ReadModel(int step, bool /*wantMesh*/)
{
  const PieceOf part{ this->Piece, this->Pieces };
  if (!IsRootFile(this->FileName))
  {
    if (!this->Steps.empty())
    {
      throw InvalidData(this->FileName +
        " is no root file of a collection (.mfem_root), which alone "
        "has time steps.");
    }
    return mfem::ReadFiles(this->FileName, this->GridFunctions, part);
  }
  if (!this->GridFunctions.empty())
  {
    throw InvalidData(this->FileName + " lists the collection's own grid functions; leave out " +
      this->GridFunctions.front() + ".");
  }
  return mfem::ReadRootFile(this->Order.at(static_cast<std::size_t>(step)), part);
}
