// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFilter.h"

#include "Conversion/ModelSource.h"
#include "Grids/FilterWork.h"
#include "Parts/ParallelRun.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace pixelexact
{
namespace
{
std::unique_ptr<WholeMesh> WholeMeshOf(MeshScope scope)
{
  switch (scope)
  {
    case MeshScope::WholeOnFirst:
      return std::make_unique<WholeMesh>(WholeMesh::Maker::First);
    case MeshScope::WholeOnEach:
      return std::make_unique<WholeMesh>(WholeMesh::Maker::Each);
    default:
      return nullptr;
  }
}
} // namespace

MeshInput::MeshInput(MeshScope scope, int port)
  : Scope(scope)
  , Port(port)
  , Source(std::make_unique<ModelSource>())
  , Whole(WholeMeshOf(scope))
{
}

MeshInput::~MeshInput() = default;

void MeshInput::FillPort(vtkInformation* port) const
{
  if (this->Scope == MeshScope::PartByBlock)
  {
    port->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
    return;
  }
  TakeGrids(port);
}

bool MeshInput::RequestParts(vtkInformationVector** inputs, vtkInformationVector* outputs) const
{
  if (this->Whole)
  {
    AskForParts(inputs[this->Port], outputs);
  }
  return this->Whole != nullptr;
}

int MeshInput::Fill(vtkAlgorithm* filter, vtkInformationVector** inputs,
  vtkInformationVector* outputs, const std::function<bool(vtkDataObject*)>& make)
{
  vtkInformationVector* const input = inputs[this->Port];
  const int filled = FillOutput(filter, vtkDataObject::GetData(outputs),
    [&]
    {
      if (!this->Whole)
      {
        return !HasNoShare(input) && make(vtkDataObject::GetData(input));
      }
      vtkDataObject* mesh = this->Whole->Of(input, outputs, filter);
      return mesh != nullptr && make(mesh);
    });
  return this->Whole ? AnswerOfAll(filled, outputs) : filled;
}

std::shared_ptr<HighOrderModel> MeshInput::Model(vtkDataObject* mesh, vtkAlgorithm* filter)
{
  return this->Source->Get(mesh, filter);
}

vtkDataObject* MeshInput::GridOf(vtkDataObject* mesh) const
{
  return this->Source->GridOf(mesh);
}
} // namespace pixelexact
