// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNekReader.h"

#include "Formats/FileText.h"
#include "Formats/Nek5000/Reader.h"
#include "Formats/Nek5000/Series.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkNekReader);

using namespace pixelexact;

vtkNekReader::vtkNekReader() = default;
vtkNekReader::~vtkNekReader() = default;

void vtkNekReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& name : this->StepFiles)
  {
    os << indent << "StepFile: " << name << "\n";
  }
}

void vtkNekReader::AddStepFileName(const char* name)
{
  this->StepFiles.emplace_back(name ? name : "");
  this->Modified();
}

void vtkNekReader::ClearStepFileNames()
{
  this->StepFiles.clear();
  this->Modified();
}

std::vector<std::string> vtkNekReader::GetFieldNames()
{
  return this->Series ? this->Series->FieldNames() : std::vector<std::string>();
}

std::vector<double> vtkNekReader::ReadTimes()
{
  this->Series.reset();
  if (this->FileName.empty())
  {
    return {}; // RequestData says so
  }
  std::vector<std::string> files{ this->FileName };
  files.insert(files.end(), this->StepFiles.begin(), this->StepFiles.end());
  this->Series = std::make_unique<nek5000::Series>(files);
  return this->Series->Times();
}

bool vtkNekReader::IsHead(const std::string& head)
{
  return head.starts_with("#std ") || head.find("filetemplate:") != std::string::npos;
}

int vtkNekReader::StepOfMesh(int step)
{
  return this->Series ? this->Series->StepOfMesh(step) : 0;
}

SolverModel vtkNekReader::ReadModel(int step, bool wantMesh)
{
  const FileTexts texts(this->Series->FilesOf(step));
  const int meshStep = this->StepOfMesh(step);
  const bool isOther = wantMesh && meshStep != step;
  const FileTexts others(isOther ? this->Series->FilesOf(meshStep) : std::vector<std::string>());
  SolverModel model = nek5000::Read(texts.Named,
    isOther      ? others.Named
      : wantMesh ? texts.Named
                 : std::vector<NamedText>());
  model.notes.insert(
    model.notes.begin(), this->Series->Notes().begin(), this->Series->Notes().end());
  return model;
}
