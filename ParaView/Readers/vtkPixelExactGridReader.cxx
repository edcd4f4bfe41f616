// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactGridReader.h"

#include "Files/TimeSeries.h"
#include "HighOrderArrays.h"
#include "vtkHighOrderSeriesReader.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include "vtkObjectFactory.h"
#include "vtkXMLUnstructuredGridReader.h"

vtkStandardNewMacro(vtkPixelExactGridReader);

//------------------------------------------------------------------------------
vtkPixelExactGridReader::vtkPixelExactGridReader()
{
  this->Convert->SetInputConnection(this->Reader->GetOutputPort());
}

//------------------------------------------------------------------------------
vtkPixelExactGridReader::~vtkPixelExactGridReader() = default;

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetNodePlacement(int placement)
{
  this->Convert->SetNodePlacement(placement);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetMirroredWedges(bool mirrored)
{
  this->Convert->SetMirroredWedges(mirrored);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetDiagnose(bool diagnose)
{
  this->Convert->SetDiagnose(diagnose);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkAlgorithm* vtkPixelExactGridReader::GetSource()
{
  return this->Convert;
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::Prepare()
{
  this->Reader->ClearFileNames();
  for (const std::string& file : this->FileNames)
  {
    this->Reader->AddFileName(file.c_str());
  }
  if (pixelexact::LowerSuffix(this->FileNames.front()) != ".vtu")
  {
    return; // what fields there are is known when it has been read
  }
  vtkNew<vtkXMLUnstructuredGridReader> head;
  head->SetFileName(this->FileNames.front().c_str());
  head->UpdateInformation();
  for (int i = 0; i < head->GetNumberOfPointArrays(); ++i)
  {
    this->Offer(head->GetPointArrayName(i), true);
  }
  for (int i = 0; i < head->GetNumberOfCellArrays(); ++i)
  {
    const std::string name = head->GetCellArrayName(i);
    if (name != pixelexact::kElementIds)
    {
      this->Offer(name, true);
    }
  }
}
