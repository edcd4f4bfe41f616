// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Nurbs/NurbsPieces.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Formats/FileText.h"
#include "Formats/MFEM/Meshes/MeshFile.h"

#include <algorithm>
#include <numeric>

namespace pixelexact::mfem
{
namespace
{
/// More than any file lists, and its square fits 64 bits.
constexpr std::int64_t kMaxPatchElements = std::int64_t{ 1 } << 31U;
constexpr const char* kOfDifferentRuns =
  "; they are of different meshes or runs: remove what an earlier one has left.";

bool HaveSamePatches(const NurbsMesh& a, const NurbsMesh& b)
{
  return std::ranges::equal(
           a.topology.patches, b.topology.patches, {}, &Cell::vertices, &Cell::vertices) &&
    std::ranges::equal(a.vectors, b.vectors, {}, &KnotVector::knots, &KnotVector::knots) &&
    std::ranges::equal(a.vectors, b.vectors, {}, &KnotVector::degree, &KnotVector::degree);
}

std::int64_t ElementCount(const NurbsMesh& mesh)
{
  std::int64_t count = 0;
  for (const auto& lines : mesh.topology.lines)
  {
    std::int64_t inPatch = 1;
    for (int d = 0; d < mesh.topology.dimension; ++d)
    {
      inPatch *= std::ssize(mesh.vectors[static_cast<std::size_t>(lines.at(d).vector)].Spans());
      inPatch = std::min(inPatch, kMaxPatchElements);
    }
    count += inPatch;
  }
  return count;
}

/// Checks that the pieces belong to one mesh and contain each of its elements once.
void RequireWhole(std::span<const MeshPiece> pieces)
{
  const MeshPiece& front = pieces.front();
  const std::int64_t elements = ElementCount(*front.file.nurbs);
  std::int64_t listed = 0;
  for (const MeshPiece& piece : pieces)
  {
    if (!piece.file.nurbs || piece.file.nurbs->pieces.empty() ||
      !HaveSamePatches(*piece.file.nurbs, *front.file.nurbs))
    {
      throw InvalidData(
        piece.name + " and " + front.name + " are no pieces of one NURBS mesh" + kOfDifferentRuns);
    }
    listed += std::ssize(piece.file.nurbs->pieces.front());
  }
  if (listed < elements)
  {
    throw InvalidData(front.name + ": this is a piece of a parallel NURBS mesh of " +
      Counted(elements, "element") + ", of which " + std::to_string(listed) +
      " are in the pieces beside it; have all pieces in one folder, named x.000000, x.000001, ... "
      "(ParMesh::Save), or save the whole mesh (ParMesh::PrintAsOne).");
  }
  // Bounds memory by the elements that the files list, not by a damaged file's number of knots.
  std::vector<bool> known(static_cast<std::size_t>(elements), false);
  for (const MeshPiece& piece : pieces)
  {
    for (const int element : piece.file.nurbs->pieces.front())
    {
      if (element < 0 || element >= elements || known[static_cast<std::size_t>(element)])
      {
        throw InvalidData(piece.name + ": element " + std::to_string(element) +
          " is in another piece, too, or none of the mesh's " + std::to_string(elements) +
          kOfDifferentRuns);
      }
      known[static_cast<std::size_t>(element)] = true;
    }
  }
}

/// The weights of all control points; none where no piece has any. `weightsOf`: of a piece.
template <class WeightsOf>
std::vector<double> JoinWeights(const NurbsSpace& space,
  const std::vector<std::vector<int>>& points, std::span<const std::string> names,
  WeightsOf&& weightsOf)
{
  std::vector<double> whole;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const std::vector<double>& own = weightsOf(p);
    if (own.empty() || points[p].empty())
    {
      continue;
    }
    if (own.size() != points[p].size())
    {
      throw InvalidData(names[p] + " has " + Counted(own.size(), "weight") + " for " +
        Counted(points[p].size(), "control point") +
        "; it is damaged, or belongs to another mesh.");
    }
    whole.resize(static_cast<std::size_t>(space.Size()), 0.0);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      double& weight = whole[static_cast<std::size_t>(points[p][i])];
      if (weight != 0.0 && weight != own[i])
      {
        throw InvalidData(names[p] + " has another weight of control point " +
          std::to_string(points[p][i]) + " than the pieces before it" + kOfDifferentRuns);
      }
      weight = own[i];
    }
  }
  return whole;
}

std::vector<std::vector<int>> PointsOf(const NurbsMesh& mesh, const NurbsSpace& space)
{
  std::vector<std::vector<int>> points;
  std::ranges::transform(mesh.pieces, std::back_inserter(points),
    [&space](const auto& elements) { return space.PointsOf(elements); });
  return points;
}

/// Elements of a piece with vertices counted as they come in the whole mesh's order.
void AddElements(const MeshFile& whole, std::span<const int> elements, MeshFile& piece)
{
  std::vector<int> vertices;
  for (const int element : elements)
  {
    const Cell& cell =
      piece.elements.emplace_back(whole.elements[static_cast<std::size_t>(element)]);
    vertices.insert(vertices.end(), cell.vertices.begin(),
      cell.vertices.begin() + TableOf(cell.geometry).vertices);
  }
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  piece.vertices = static_cast<int>(vertices.size());
  for (Cell& cell : piece.elements)
  {
    for (int& vertex : std::span(cell.vertices).first(TableOf(cell.geometry).vertices))
    {
      vertex = static_cast<int>(std::ranges::lower_bound(vertices, vertex) - vertices.begin());
    }
  }
}

void RequireOneSpace(const GridFunctionFile& one, const std::string& name,
  const GridFunctionFile& other, const std::string& otherName)
{
  const auto ordersOf = [](const GridFunctionFile& file)
  { return file.nurbs ? file.nurbs->orders : std::vector<int>(); };
  if (one.collection != other.collection || one.components != other.components ||
    ordersOf(one) != ordersOf(other))
  {
    throw InvalidData(name + " and " + otherName + " are of different spaces" + kOfDifferentRuns);
  }
}
} // namespace

MeshFile JoinNurbs(std::span<MeshPiece> pieces)
{
  RequireWhole(pieces);
  auto nurbs = std::make_shared<NurbsMesh>(*pieces.front().file.nurbs);
  nurbs->pieces.clear();
  nurbs->weights.clear();
  std::vector<std::string> names;
  GridFunctionFile own; // of the mesh's own space; as many values as its size is compared with
  own.collection = "NURBS";
  for (const MeshPiece& piece : pieces)
  {
    nurbs->pieces.push_back(piece.file.nurbs->pieces.front());
    names.push_back(piece.name);
    own.values.resize(own.values.size() + piece.file.nodes->values.size());
  }
  MeshFile whole = MakeNurbsMesh(*nurbs);
  const NurbsSpace space = NameErrors(names.front(), [&] { return NurbsSpace(*nurbs, own); });
  std::vector<double> weights = JoinWeights(space, PointsOf(*nurbs, space), names,
    [pieces](std::size_t p) -> const std::vector<double>&
    { return pieces[p].file.nurbs->weights; });
  nurbs->weights = std::move(weights);
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    AddElements(whole, nurbs->pieces[p], pieces[p].file);
  }
  whole.nurbs = std::move(nurbs);
  return whole;
}

PiecedFunction ReadPieces(const NurbsMesh& mesh, std::span<const GridFunctionFile> files,
  std::span<const std::string> names)
{
  GridFunctionFile header = files.front();
  if (header.nurbs)
  {
    header.nurbs->weights.clear();
  }
  const auto components = static_cast<std::size_t>(header.components);
  std::vector<double> values;
  for (std::size_t p = 0; p < files.size(); ++p)
  {
    const GridFunctionFile& file = files[p];
    RequireOneSpace(file, names[p], files.front(), names.front());
    if (file.byPatches || file.values.size() % components != 0)
    {
      throw InvalidData(names[p] + ": its " + Counted(file.values.size(), "value") +
        " are not those of the control points of its elements; the file is damaged.");
    }
    const std::size_t size = file.values.size() / components;
    for (std::size_t i = 0; i < size; ++i)
    {
      for (std::size_t c = 0; c < components; ++c)
      {
        values.push_back(file.values[file.byNodes ? c * size + i : i * components + c]);
      }
    }
  }
  header.values = std::move(values);
  NurbsSpace space = NameErrors(names.front(), [&] { return NurbsSpace(mesh, header); });
  PiecedFunction function{ std::move(space), std::move(header.values), {}, {}, true };
  function.points = PointsOf(mesh, function.space);
  std::vector<std::int64_t> rowOf(static_cast<std::size_t>(function.space.Size()), -1);
  std::size_t row = 0;
  for (std::size_t p = 0; p < files.size(); ++p)
  {
    const std::vector<int>& points = function.points[p];
    if (files[p].values.size() != points.size() * components)
    {
      throw InvalidData(names[p] + " holds " + Counted(files[p].values.size(), "value") + ", but " +
        files[p].collection + " with VDim " + std::to_string(components) + " has " +
        std::to_string(points.size() * components) + " on this piece of the mesh of " +
        Counted(mesh.pieces[p].size(), "element") +
        "; the file is cut short, or belongs to another mesh or to another piece of it.");
    }
    function.first.push_back(row);
    for (const int point : points)
    {
      std::int64_t& known = rowOf[static_cast<std::size_t>(point)];
      known = known < 0 ? static_cast<std::int64_t>(row) : known;
      const auto at = [&](std::int64_t r)
      { return function.values.begin() + r * static_cast<std::int64_t>(components); };
      function.isOne =
        function.isOne && std::equal(at(known), at(known + 1), at(static_cast<std::int64_t>(row)));
      ++row;
    }
  }
  if (header.nurbs)
  {
    static const std::vector<double> none;
    std::vector<double> weights = JoinWeights(function.space, function.points, names,
      [&](std::size_t p) -> const std::vector<double>&
      { return files[p].nurbs ? files[p].nurbs->weights : none; });
    if (!weights.empty())
    {
      NameErrors(names.front(), [&] { function.space.SetWeights(std::move(weights)); });
    }
  }
  return function;
}
} // namespace pixelexact::mfem
