// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlexiReader.h"

#include "Formats/Flexi/Series.h"
#include "Formats/Hdf5/Hdf5File.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFlexiReader);

using namespace pixelexact;

vtkFlexiReader::vtkFlexiReader() = default;
vtkFlexiReader::~vtkFlexiReader() = default;

void vtkFlexiReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& name : this->StateFiles)
  {
    os << indent << "StateFile: " << name << "\n";
  }
}

void vtkFlexiReader::AddStateFileName(const char* name)
{
  this->StateFiles.emplace_back(name ? name : "");
  this->Modified();
}

void vtkFlexiReader::ClearStateFileNames()
{
  this->StateFiles.clear();
  this->Modified();
}

std::vector<std::string> vtkFlexiReader::GetFieldNames()
{
  return this->Series ? this->Series->FieldNames() : std::vector<std::string>();
}

int vtkFlexiReader::CanReadFile(const char* name)
{
  return this->Superclass::CanReadFile(name) != 0 && flexi::IsFile(name) ? 1 : 0;
}

std::vector<double> vtkFlexiReader::ReadTimes()
{
  this->Series.reset();
  if (this->FileName.empty())
  {
    return {}; // RequestData says so
  }
  std::vector<std::string> files{ this->FileName };
  files.insert(files.end(), this->StateFiles.begin(), this->StateFiles.end());
  this->Series = std::make_unique<flexi::Series>(files);
  return this->Series->Times();
}

bool vtkFlexiReader::IsHead(const std::string& head)
{
  return IsHdf5(head);
}

int vtkFlexiReader::StepOfMesh(int step)
{
  return this->Series ? this->Series->StepOfMesh(step) : 0;
}

SolverModel vtkFlexiReader::ReadModel(int step, bool wantMesh)
{
  return this->Series->Read(step, wantMesh);
}
