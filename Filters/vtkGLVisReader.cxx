// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGLVisReader.h"

#include "Formats/FileText.h"
#include "Formats/MFEM/Reader.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGLVisReader);

using namespace pixelexact;

vtkGLVisReader::vtkGLVisReader() = default;
vtkGLVisReader::~vtkGLVisReader() = default;

void vtkGLVisReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkGLVisReader::IsHead(const std::string& head)
{
  return mfem::IsStream(head);
}

SolverModel vtkGLVisReader::ReadModel(int /*step*/, bool /*wantMesh*/)
{
  const std::string text = ReadFileText(this->FileName);
  return mfem::ReadStream({ this->FileName, text });
}
