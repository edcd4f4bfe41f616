// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/VtkFunctions.h"

#include "Surfaces/VtkSampledFunction.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/Combined.h"
#include "Trace/Surfaces/SearchedSurface.h"

#include "vtkCollection.h"
#include "vtkImplicitBoolean.h"
#include "vtkImplicitFunction.h"
#include "vtkImplicitFunctionCollection.h"
#include "vtkSmartPointer.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
double ValueAt(vtkImplicitFunction* function, const Vec3& x)
{
  return function->FunctionValue(glm::value_ptr(x));
}

/// A tree of booleans and parts, which gives Combined's rule.
struct Node
{
  int operation = -1; ///< of vtkImplicitBoolean; -1: a part
  std::size_t part = 0;
  std::vector<Node> below;

  [[nodiscard]] bool IsInside(const std::vector<bool>& inside) const
  {
    const auto in = [&inside](const Node& node) { return node.IsInside(inside); };
    switch (operation)
    {
      case vtkImplicitBoolean::VTK_UNION:
        return std::ranges::any_of(below, in);
      case vtkImplicitBoolean::VTK_INTERSECTION:
        return std::ranges::all_of(below, in);
      case vtkImplicitBoolean::VTK_DIFFERENCE:
        return in(below[0]) && std::none_of(below.begin() + 1, below.end(), in);
      default:
        return inside[part];
    }
  }
};

/// Returns false if a function has no closed form.
bool Add(vtkImplicitFunction* function, const ClosedForm& closedForm,
  std::vector<Combined::Part>& parts, Node& node)
{
  auto* boolean = vtkImplicitBoolean::SafeDownCast(function);
  if (boolean == nullptr)
  {
    std::shared_ptr<const Surface> surface = closedForm(function);
    node.part = parts.size();
    parts.push_back({ surface,
      [keep = vtkSmartPointer<vtkImplicitFunction>(function)](const Vec3& x)
      { return ValueAt(keep, x); } });
    return surface != nullptr;
  }
  if (boolean->GetTransform() != nullptr)
  {
    return false;
  }
  node.operation = boolean->GetOperationType();
  if (node.operation == vtkImplicitBoolean::VTK_UNION_OF_MAGNITUDES)
  {
    // A search does not find a surface either, because the function has no change of sign.
    throw Error("a vtkImplicitBoolean of type union of magnitudes has no inside and no "
                "outside; cut with its functions one by one");
  }
  vtkImplicitFunctionCollection* functions = boolean->GetFunction();
  if (functions->GetNumberOfItems() == 0)
  {
    throw Error("a vtkImplicitBoolean without functions cuts nothing; add some");
  }
  vtkCollectionSimpleIterator at;
  functions->InitTraversal(at);
  while (vtkImplicitFunction* next = functions->GetNextImplicitFunction(at))
  {
    if (!Add(next, closedForm, parts, node.below.emplace_back()))
    {
      return false;
    }
  }
  return true;
}
} // namespace

std::shared_ptr<const Surface> FromBoolean(
  vtkImplicitBoolean* boolean, const ClosedForm& closedForm)
{
  std::vector<Combined::Part> parts;
  Node root;
  if (!Add(boolean, closedForm, parts, root))
  {
    return nullptr;
  }
  return std::make_shared<Combined>(std::move(parts),
    [root = std::move(root)](const std::vector<bool>& inside) { return root.IsInside(inside); });
}

std::shared_ptr<const Surface> FromAnyFunction(
  vtkImplicitFunction* function, const Box3& box, int samples)
{
  return std::make_shared<SearchedSurface>(
    std::make_shared<VtkSampledFunction>(function, box), box, samples);
}
} // namespace pixelexact
