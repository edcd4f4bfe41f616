// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/FunctionSpace.h"

#include "Formats/MFEM/Meshes/MeshFile.h"

namespace pixelexact::mfem
{
/// Takes unknowns of one component, one after the other, with their signs.
class FunctionSpace::Writer
{
public:
  Writer(std::span<const double> values, std::int64_t stride, std::int64_t first, double* out)
    : Values(values)
    , Stride(stride)
    , First(first)
    , Out(out)
  {
  }

  void Take(std::int64_t unknown) { *Out++ = At(unknown); }

  /// The unknowns of an edge or a face that begin at `first`, in the order of an orientation.
  void Take(std::int64_t first, std::span<const int> order)
  {
    for (const int entry : order)
    {
      *Out++ = entry >= 0 ? At(first + entry) : -At(first - 1 - entry);
    }
  }

  /// Mixes the last `count` values, pair by pair.
  void Mix(std::size_t count, const std::array<double, 4>& matrix)
  {
    for (double* pair = Out - count; pair + 1 < Out; pair += 2)
    {
      const double a = pair[0];
      const double b = pair[1];
      pair[0] = matrix[0] * a + matrix[1] * b;
      pair[1] = matrix[2] * a + matrix[3] * b;
    }
  }

private:
  [[nodiscard]] double At(std::int64_t unknown) const { return Values[First + unknown * Stride]; }

  std::span<const double> Values;
  std::int64_t Stride;
  std::int64_t First;
  double* Out;
};

FunctionSpace::FunctionSpace(
  const MeshFile& mesh, const Topology& topology, const Collection& collection)
  : Mesh(mesh)
  , Entities(topology)
  , Functions(collection)
{
  FirstEdgeUnknown =
    static_cast<std::int64_t>(mesh.vertices) * collection.Unknowns(Geometry::Point);
  Unknowns = FirstEdgeUnknown +
    static_cast<std::int64_t>(topology.Edges()) * collection.Unknowns(Geometry::Segment);
  if (collection.Unknowns(Geometry::Triangle) > 0 || collection.Unknowns(Geometry::Square) > 0)
  {
    for (int f = 0; f < topology.Faces(); ++f)
    {
      FirstFaceUnknown.push_back(Unknowns);
      Unknowns += collection.Unknowns(topology.FaceGeometry(f));
    }
  }
  for (const Cell& cell : mesh.elements)
  {
    FirstInteriorUnknown.push_back(Unknowns);
    Unknowns += collection.Unknowns(cell.geometry);
  }
}

void FunctionSpace::GatherComponent(std::size_t element, Writer& writer) const
{
  const Cell& cell = Mesh.elements[element];
  const int atVertex = Functions.Unknowns(Geometry::Point);
  const int vertices = atVertex > 0 ? TableOf(cell.geometry).vertices : 0;
  for (const int v : std::span(cell.vertices).first(vertices))
  {
    for (int k = 0; k < atVertex; ++k)
    {
      writer.Take(static_cast<std::int64_t>(v) * atVertex + k);
    }
  }
  if (const int onEdge = Functions.Unknowns(Geometry::Segment); onEdge > 0)
  {
    for (const Incidence& edge : Entities.EdgesOf(element))
    {
      writer.Take(FirstEdgeUnknown + static_cast<std::int64_t>(edge.entity) * onEdge,
        Functions.UnknownOrder(Geometry::Segment, edge.orientation));
    }
  }
  if (!FirstFaceUnknown.empty())
  {
    for (const Incidence& face : Entities.FacesOf(element))
    {
      const Geometry geometry = Entities.FaceGeometry(face.entity);
      if (Functions.Unknowns(geometry) == 0)
      {
        continue;
      }
      const auto order = Functions.UnknownOrder(geometry, face.orientation);
      writer.Take(FirstFaceUnknown[face.entity], order);
      if (geometry == Geometry::Triangle && Functions.MixesTriangleUnknowns())
      {
        writer.Mix(order.size(), Functions.TriangleMixing(face.orientation));
      }
    }
  }
  for (int k = 0; k < Functions.Unknowns(cell.geometry); ++k)
  {
    writer.Take(FirstInteriorUnknown[element] + k);
  }
}

void FunctionSpace::Gather(std::size_t element, std::span<const double> values, int components,
  bool byNodes, std::span<double> source) const
{
  const std::size_t perComponent = source.size() / components;
  for (int c = 0; c < components; ++c)
  {
    Writer writer(values, byNodes ? 1 : components, byNodes ? c * Unknowns : c,
      source.data() + c * perComponent);
    GatherComponent(element, writer);
  }
}
} // namespace pixelexact::mfem
