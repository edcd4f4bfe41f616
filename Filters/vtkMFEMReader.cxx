// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMFEMReader.h"

#include "Formats/MFEM/Reader.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMFEMReader);

using namespace pixelexact;

vtkMFEMReader::vtkMFEMReader() = default;
vtkMFEMReader::~vtkMFEMReader() = default;

void vtkMFEMReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& name : this->GridFunctions)
  {
    os << indent << "GridFunction: " << name << "\n";
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

SolverModel vtkMFEMReader::ReadModel(int /*step*/, bool /*wantMesh*/)
{
  return mfem::ReadFiles(this->FileName, this->GridFunctions);
}
