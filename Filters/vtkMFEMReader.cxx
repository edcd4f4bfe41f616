// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMFEMReader.h"

#include "Formats/FileText.h"
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
  const std::string mesh = ReadFileText(this->FileName);
  std::vector<std::string> texts;
  texts.reserve(this->GridFunctions.size());
  std::vector<mfem::NamedText> fields;
  for (const auto& name : this->GridFunctions)
  {
    texts.push_back(ReadFileText(name));
    fields.push_back({ name, texts.back() });
  }
  return mfem::Read({ this->FileName, mesh }, fields);
}
