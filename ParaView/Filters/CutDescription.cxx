// SPDX-License-Identifier: BSD-3-Clause
#include "CutDescription.h"

#include "CompositeParts.h"
#include "vtkImplicitTorus.h"

#include "Core/Base/Error.h"

#include "vtkBox.h"
#include "vtkCompositeDataSet.h"
#include "vtkCylinder.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkQuadric.h"
#include "vtkSphere.h"
#include "vtkTransform.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace pixelexact
{
namespace
{
enum Kind
{
  kPlane,
  kSphere,
  kCylinder,
  kBox,
  kQuadric,
  kTorus
};

constexpr std::size_t kParameters = 2;
constexpr std::size_t kMatrix = kParameters + 10;
constexpr std::size_t kNumbers = kMatrix + 16;
using Tuple = std::array<double, kNumbers>;

/// Writes the kind and the parameters. False for other functions.
bool Write(vtkImplicitFunction* function, Tuple& tuple)
{
  double* const p = tuple.data() + kParameters;
  if (auto* const plane = vtkPlane::SafeDownCast(function))
  {
    tuple[0] = kPlane;
    plane->GetOrigin(p);
    // ParaView's plane has an offset, which only its value contains.
    plane->EvaluateGradient(p, p + 3);
    const double value = plane->EvaluateFunction(p);
    const double square = p[3] * p[3] + p[4] * p[4] + p[5] * p[5];
    for (int d = 0; d < 3 && square > 0.0; ++d)
    {
      p[d] -= value / square * p[3 + d];
    }
  }
  else if (auto* const sphere = vtkSphere::SafeDownCast(function))
  {
    tuple[0] = kSphere;
    sphere->GetCenter(p);
    p[3] = sphere->GetRadius();
  }
  else if (auto* const cylinder = vtkCylinder::SafeDownCast(function))
  {
    tuple[0] = kCylinder;
    cylinder->GetCenter(p);
    cylinder->GetAxis(p + 3);
    p[6] = cylinder->GetRadius();
  }
  else if (auto* const box = vtkBox::SafeDownCast(function))
  {
    tuple[0] = kBox;
    box->GetXMin(p);
    box->GetXMax(p + 3);
  }
  else if (auto* const quadric = vtkQuadric::SafeDownCast(function))
  {
    tuple[0] = kQuadric;
    quadric->GetCoefficients(p);
  }
  else if (auto* const torus = vtkImplicitTorus::SafeDownCast(function))
  {
    tuple[0] = kTorus;
    torus->GetCenter(p);
    torus->GetAxis(p + 3);
    p[6] = torus->GetRadius();
    p[7] = torus->GetTubeRadius();
  }
  else
  {
    return false;
  }
  return true;
}

Tuple TupleOf(const DescribedCut& cut)
{
  Tuple tuple{};
  tuple[1] = cut.inverted ? 1.0 : 0.0;
  if (!Write(cut.function, tuple))
  {
    throw InvalidData("this function cannot be used here; choose a plane, box, sphere, cylinder, "
                      "quadric or torus.");
  }
  vtkNew<vtkMatrix4x4> matrix;
  if (auto* const transform = cut.function->GetTransform())
  {
    auto* const homogeneous = vtkHomogeneousTransform::SafeDownCast(transform);
    if (homogeneous == nullptr)
    {
      throw InvalidData("the function is moved by a transform that is no matrix; remove it.");
    }
    homogeneous->Update();
    matrix->DeepCopy(homogeneous->GetMatrix());
  }
  std::copy_n(matrix->GetData(), 16, tuple.begin() + kMatrix);
  return tuple;
}

vtkSmartPointer<vtkImplicitFunction> FunctionOf(int kind, const double* p)
{
  switch (kind)
  {
    case kPlane:
    {
      auto plane = vtkSmartPointer<vtkPlane>::New();
      plane->SetOrigin(p[0], p[1], p[2]);
      plane->SetNormal(p[3], p[4], p[5]);
      return plane;
    }
    case kSphere:
    {
      auto sphere = vtkSmartPointer<vtkSphere>::New();
      sphere->SetCenter(p[0], p[1], p[2]);
      sphere->SetRadius(p[3]);
      return sphere;
    }
    case kCylinder:
    {
      auto cylinder = vtkSmartPointer<vtkCylinder>::New();
      cylinder->SetCenter(p[0], p[1], p[2]);
      cylinder->SetAxis(p[3], p[4], p[5]);
      cylinder->SetRadius(p[6]);
      return cylinder;
    }
    case kBox:
    {
      auto box = vtkSmartPointer<vtkBox>::New();
      box->SetXMin(p[0], p[1], p[2]);
      box->SetXMax(p[3], p[4], p[5]);
      return box;
    }
    case kQuadric:
    {
      auto quadric = vtkSmartPointer<vtkQuadric>::New();
      quadric->SetCoefficients(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9]);
      return quadric;
    }
    case kTorus:
    {
      auto torus = vtkSmartPointer<vtkImplicitTorus>::New();
      torus->SetCenter(p[0], p[1], p[2]);
      torus->SetAxis(p[3], p[4], p[5]);
      torus->SetRadius(p[6]);
      torus->SetTubeRadius(p[7]);
      return torus;
    }
    default:
      return nullptr;
  }
}

vtkDoubleArray* ArrayOf(vtkUnstructuredGrid* grid, const char* name)
{
  auto* const array =
    grid != nullptr ? vtkDoubleArray::SafeDownCast(grid->GetFieldData()->GetArray(name)) : nullptr;
  return array != nullptr && array->GetNumberOfComponents() == static_cast<int>(kNumbers) ? array
                                                                                          : nullptr;
}

vtkDoubleArray* FirstArrayOf(vtkDataObject* data, const char* name)
{
  auto* const composite = vtkCompositeDataSet::SafeDownCast(data);
  if (composite == nullptr)
  {
    return ArrayOf(vtkUnstructuredGrid::SafeDownCast(data), name);
  }
  for (const CompositePart& part : PartsOf(composite))
  {
    if (vtkDoubleArray* const array = ArrayOf(part.grid, name))
    {
      return array;
    }
  }
  return nullptr;
}

/// Gives a grid a FieldData of its own, whose list of arrays may be changed.
void OwnFieldData(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkFieldData> own;
  own->ShallowCopy(grid->GetFieldData());
  grid->SetFieldData(own);
}
} // namespace

void AddCuts(vtkUnstructuredGrid* grid, const char* array, const std::vector<DescribedCut>& cuts)
{
  vtkNew<vtkDoubleArray> all;
  all->SetName(array);
  all->SetNumberOfComponents(static_cast<int>(kNumbers));
  if (vtkDoubleArray* const before = ArrayOf(grid, array))
  {
    all->DeepCopy(before);
  }
  for (const DescribedCut& cut : cuts)
  {
    all->InsertNextTuple(TupleOf(cut).data());
  }
  OwnFieldData(grid);
  grid->GetFieldData()->AddArray(all);
}

void RemoveCuts(vtkUnstructuredGrid* grid, const char* array)
{
  OwnFieldData(grid);
  grid->GetFieldData()->RemoveArray(array);
}

std::vector<DescribedCut> CutsOf(vtkDataObject* data, const char* array)
{
  std::vector<DescribedCut> cuts;
  vtkDoubleArray* const tuples = FirstArrayOf(data, array);
  const vtkIdType count = tuples != nullptr ? tuples->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    Tuple tuple;
    tuples->GetTypedTuple(i, tuple.data());
    const auto function = FunctionOf(static_cast<int>(tuple[0]), tuple.data() + kParameters);
    if (function == nullptr)
    {
      return {};
    }
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(tuple.data() + kMatrix);
    if (!matrix->IsIdentity())
    {
      vtkNew<vtkTransform> transform;
      transform->SetMatrix(matrix);
      function->SetTransform(transform);
    }
    cuts.push_back({ function, tuple[1] != 0.0 });
  }
  return cuts;
}
} // namespace pixelexact
