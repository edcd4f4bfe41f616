// SPDX-License-Identifier: BSD-3-Clause
#include "MeshPart.h"

#include "BoundaryArrays.h"
#include "Core/Base/Error.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Fingerprint.h"
#include "JoinedArrays.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// The parts that a caller holds.
struct PartRegistry
{
  std::mutex mutex;
  std::vector<std::weak_ptr<const MeshPart>> parts;

  static PartRegistry& Instance()
  {
    static PartRegistry registry;
    return registry;
  }
};
} // namespace

// Points and cells are not in the key: the fingerprints detect whether they are the same.
MeshPart::Key MeshPart::KeyOf(vtkUnstructuredGrid* grid)
{
  Key key;
  const auto add = [&key](vtkAbstractArray* array) { key.emplace_back(array, array->GetMTime()); };
  vtkFieldData* data = grid->GetFieldData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetName() && std::string(array->GetName()).starts_with(kMeshPrefix))
    {
      add(array);
    }
  }
  std::ranges::sort(key); // filters may change their order
  if (vtkAbstractArray* ids = grid->GetCellData()->GetAbstractArray(kElementIds))
  {
    add(ids);
  }
  return key;
}

MeshPart::MeshPart(vtkUnstructuredGrid* grid, Key key)
  : Arrays(std::move(key))
{
  const std::string prefix = kMeshPrefix;
  auto& keeper = Storage.arrays;
  auto view = ViewExpansion(grid, prefix, -1, keeper);
  Stored = static_cast<vtkIdType>(view.spaceOf.size());
  const auto centre = ViewArray<double>(grid, prefix + "Centre", 3, Stored, keeper);
  const auto size = ViewArray<double>(grid, prefix + "Size", 1, Stored, keeper);
  const auto uncertainty = ViewArray<double>(grid, prefix + "Uncertainty", 1, Stored, keeper);
  const auto source = ViewArray<std::int64_t>(grid, prefix + "SourceCell", 1, Stored, keeper);
  Fingerprints = ViewArray<std::int64_t>(grid, prefix + "Fingerprint", 1, Stored, keeper);

  cells_ = std::make_unique<CellElements>(grid, Stored);
  CompareCells(grid);
  mesh_.map = Storage.Assemble(std::move(view), *cells_, 3);
  mesh_.centre = cells_->Select(centre, Storage.doubles, 3);
  mesh_.size = cells_->Select(size, Storage.doubles);
  mesh_.uncertainty = cells_->Select(uncertainty, Storage.doubles);
  Sources = cells_->Select(source, Storage.longs);
  Validate(mesh_);
  Boundary = ReadBoundary(grid, mesh_, *cells_, Stored);
  mesh_.isShell = IsShell(grid);
  for (int e = 0; mesh_.isShell && e < mesh_.Elements(); ++e)
  {
    if (mesh_.ShapeOf(e) != Shape::Prism && mesh_.ShapeOf(e) != Shape::Hexahedron)
    {
      throw InvalidData(
        std::string("array '") + kSlab + "' says that the mesh is a surface, but it has solids");
    }
  }
}

MeshPart::MeshPart(std::vector<std::shared_ptr<const MeshPart>> parts)
  : Parts(std::move(parts))
{
  std::vector<const Expansion*> maps;
  std::vector<std::span<const double>> centre;
  std::vector<std::span<const double>> size;
  std::vector<std::span<const double>> uncertainty;
  std::vector<std::span<const std::int64_t>> source;
  const auto isShell = [](const auto& part) { return part->mesh_.isShell; };
  mesh_.isShell = std::ranges::any_of(Parts, isShell);
  if (mesh_.isShell && !std::ranges::all_of(Parts, isShell))
  {
    throw Unsupported("some blocks are surfaces in space and others are not; draw them apart "
                      "(Extract Block)");
  }
  for (const auto& part : Parts)
  {
    // Elements of the parts follow each other, and so do their faces.
    for (AttributedFace face : part->Boundary)
    {
      face.face.element += static_cast<std::int32_t>(Stored);
      Boundary.push_back(face);
    }
    maps.push_back(&part->mesh_.map);
    centre.push_back(part->mesh_.centre);
    size.push_back(part->mesh_.size);
    uncertainty.push_back(part->mesh_.uncertainty);
    source.push_back(part->Sources);
    Stored += part->mesh_.Elements();
  }
  mesh_.map = pixelexact::Join(maps, Storage);
  mesh_.centre = pixelexact::Join(centre, Storage.doubles);
  mesh_.size = pixelexact::Join(size, Storage.doubles);
  mesh_.uncertainty = pixelexact::Join(uncertainty, Storage.doubles);
  Sources = pixelexact::Join(source, Storage.longs);
  Validate(mesh_);
}

MeshPart::~MeshPart() = default;

void MeshPart::CompareCells(vtkUnstructuredGrid* grid) const
{
  cells_->Compare(
    grid, [grid](Hash hash) { return CellFingerprints(grid, hash); }, Fingerprints,
    "is not the one that its coefficients were made from: it was cut (Clip), its points were moved "
    "(Transform, Warp), "
    "or other cells were put before it (Append)");
}

std::shared_ptr<const MeshPart> MeshPart::Of(vtkUnstructuredGrid* grid)
{
  auto& registry = PartRegistry::Instance();
  const std::scoped_lock lock(registry.mutex);
  std::erase_if(registry.parts, [](const auto& part) { return part.expired(); });
  Key key = KeyOf(grid);
  for (const auto& known : registry.parts)
  {
    // A grid without element ids may have lost cells.
    if (auto part = known.lock(); part && part->Parts.empty() && part->Arrays == key &&
        part->Cells().Cells() == static_cast<std::size_t>(grid->GetNumberOfCells()))
    {
      part->CompareCells(grid);
      return part;
    }
  }
  std::shared_ptr<const MeshPart> part(new MeshPart(grid, std::move(key)));
  registry.parts.push_back(part);
  return part;
}

std::shared_ptr<const MeshPart> MeshPart::Join(std::vector<std::shared_ptr<const MeshPart>> parts)
{
  auto& registry = PartRegistry::Instance();
  const std::scoped_lock lock(registry.mutex);
  for (const auto& known : registry.parts)
  {
    if (auto part = known.lock(); part && !part->Parts.empty() && part->Parts == parts)
    {
      return part;
    }
  }
  std::shared_ptr<const MeshPart> part(new MeshPart(std::move(parts)));
  registry.parts.push_back(part);
  return part;
}

const Locator& MeshPart::GetLocator() const
{
  std::call_once(LocatorOnce,
    [this]
    {
      locator_ = std::make_unique<Locator>(mesh_);
      LocatorMade = true;
    });
  return *locator_;
}

const FaceTable& MeshPart::GetFaces() const
{
  std::call_once(FacesOnce,
    [this]
    {
      faces_ = std::make_unique<FaceTable>(GetLocator().Index());
      FacesMade = true;
    });
  return *faces_;
}
} // namespace pixelexact
