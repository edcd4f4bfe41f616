// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Nurbs/NurbsMesh.h"

#include "Formats/MFEM/Meshes/MeshFile.h"

#include <algorithm>
#include <cmath>

namespace pixelexact::mfem
{
namespace
{
/// Tolerance for knots of two patches that meet, relative to their length. It covers digits of
/// hand-written files.
constexpr double kSameKnots = 1e-12;

void SkipNumbers(TextScanner& scanner, int count)
{
  for (int i = 0; i < count; ++i)
  {
    scanner.Number("a number of a spacing or refinement");
  }
}

/// Skips the section that describes how to divide edges. It does not affect other contents of the
/// file.
void SkipSpacing(TextScanner& scanner, const NurbsMesh& nurbs)
{
  if (scanner.Peek() == "refinements")
  {
    scanner.Word("refinements");
    SkipNumbers(scanner, nurbs.topology.dimension);
  }
  if (scanner.Peek() == "knotvector_refinements")
  {
    scanner.Word("refinements");
    for (std::size_t i = 0; i < nurbs.vectors.size(); ++i)
    {
      SkipNumbers(scanner, scanner.Count("a number of refinement factors", 2));
    }
  }
  scanner.Expect("spacing");
  const int formulas = scanner.Count("the number of spacing formulas", 8);
  for (int i = 0; i < formulas; ++i)
  {
    scanner.Integer("a knot vector", 0, static_cast<int>(nurbs.vectors.size()) - 1);
    scanner.Integer("a spacing type");
    const int integers = scanner.Count("the number of integer parameters", 2);
    const int reals = scanner.Count("the number of real parameters", 2);
    SkipNumbers(scanner, integers);
    SkipNumbers(scanner, reals);
  }
}

std::vector<int> ReadList(TextScanner& scanner, const char* what)
{
  std::vector<int> list(static_cast<std::size_t>(scanner.Count(what, 2)));
  std::ranges::generate(list, [&] { return scanner.Integer(what); });
  return list;
}

PatchNumbering ControlPoints(const NurbsMesh& nurbs)
{
  std::vector<int> counts;
  std::ranges::transform(
    nurbs.vectors, std::back_inserter(counts), [](const KnotVector& v) { return v.Points(); });
  return { nurbs.topology, std::move(counts) };
}

void RequirePositive(TextScanner& scanner, const std::vector<double>& weights)
{
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    if (!(weights[i] > 0.0) || !std::isfinite(weights[i]))
    {
      scanner.Fail("the weight of control point " + std::to_string(i) +
        " is not positive; elements whose weights are zero or negative have poles, or none of "
        "their points where the control points are: refit them with positive weights.");
    }
  }
}

bool AreSame(const KnotVector& a, const KnotVector& b)
{
  const double slack = kSameKnots * (a.knots.back() - a.knots.front());
  return a.degree == b.degree && a.knots.size() == b.knots.size() &&
    std::equal(a.knots.begin(), a.knots.end(), b.knots.begin(),
      [slack](double x, double y) { return std::fabs(x - y) <= slack; });
}

struct Patch
{
  int dimension = 0;          ///< of its space
  std::vector<double> points; ///< coordinates and weight, the first direction fastest
};

Patch ReadPatch(TextScanner& scanner, NurbsMesh& nurbs, std::vector<bool>& known, std::size_t p)
{
  const PatchTopology& topology = nurbs.topology;
  scanner.Expect("knotvectors");
  scanner.Integer("the patch's dimension", topology.dimension, topology.dimension);
  std::int64_t count = 1;
  for (int d = 0; d < topology.dimension; ++d)
  {
    const PatchTopology::Line& line = topology.lines[p].at(d);
    KnotVector vector = ReadKnotVector(scanner);
    count *= vector.Points();
    vector = line.isReversed ? vector.Flipped() : vector;
    const auto at = static_cast<std::size_t>(line.vector);
    if (known[at] && !AreSame(vector, nurbs.vectors[at]))
    {
      scanner.Fail("patch " + std::to_string(p) + " has another knot vector in direction " +
        std::to_string(d) + " than a patch that it shares an edge or a side with.");
    }
    if (!known[at])
    {
      nurbs.vectors[at] = std::move(vector);
      known[at] = true;
    }
  }
  scanner.Expect("dimension");
  Patch patch;
  patch.dimension = ReadSpaceDimension(scanner, topology.dimension);
  const std::string_view kind = scanner.Word("the control points");
  const bool isCartesian = kind == "controlpoints_cartesian";
  if (!isCartesian && kind != "controlpoints" && kind != "controlpoints_homogeneous")
  {
    scanner.Fail("'" + std::string(kind.substr(0, 40)) +
      "' is no kind of control points; 'controlpoints' and 'controlpoints_cartesian' are.");
  }
  std::vector<double> weights;
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::size_t first = patch.points.size();
    for (int d = 0; d <= patch.dimension; ++d)
    {
      patch.points.push_back(scanner.Number("a control point"));
    }
    weights.push_back(patch.points.back());
    for (std::size_t d = first; d + 1 < patch.points.size() && !isCartesian; ++d)
    {
      patch.points[d] /= weights.back();
    }
  }
  RequirePositive(scanner, weights);
  return patch;
}

/// Nodes and weights that MFEM computes from patches: at shared control points the last patch
/// determines them.
GridFunctionFile ReadPatches(TextScanner& scanner, NurbsMesh& nurbs)
{
  nurbs.vectors.resize(static_cast<std::size_t>(nurbs.topology.vectors));
  std::vector<bool> known(nurbs.vectors.size(), false);
  std::vector<Patch> patches;
  std::int64_t total = 0;
  for (std::size_t p = 0; p < nurbs.topology.patches.size(); ++p)
  {
    patches.push_back(ReadPatch(scanner, nurbs, known, p));
    total += static_cast<std::int64_t>(patches.back().points.size());
    if (patches.back().dimension != patches.front().dimension)
    {
      scanner.Fail("the control points of patch " + std::to_string(p) + " are in " +
        std::to_string(patches.back().dimension) + "-D, those of the first one in " +
        std::to_string(patches.front().dimension) + "-D.");
    }
  }
  if (std::ranges::find(known, false) != known.end() || patches.empty())
  {
    scanner.Fail("the mesh has a knot vector of no patch; the section 'edges' is damaged.");
  }
  const PatchNumbering numbering = ControlPoints(nurbs);
  if (numbering.Size() > total)
  {
    scanner.Fail("the mesh has more vertices than control points; it is damaged.");
  }
  GridFunctionFile nodes;
  nodes.collection = "NURBS";
  nodes.components = patches.front().dimension;
  nodes.byNodes = false;
  const auto components = static_cast<std::size_t>(nodes.components);
  const auto size = static_cast<std::size_t>(numbering.Size());
  nodes.values.resize(size * components);
  nurbs.weights.assign(size, 1.0);
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    auto from = patches[p].points.begin();
    for (const int number : numbering.GridOf(p))
    {
      const auto at = static_cast<std::size_t>(number);
      std::copy_n(from, components, &nodes.values[at * components]);
      nurbs.weights[at] = from[nodes.components];
      from += nodes.components + 1;
    }
  }
  return nodes;
}

void ReadKnotVectors(TextScanner& scanner, NurbsMesh& nurbs)
{
  const int count = scanner.Count("the number of knot vectors", 8);
  if (count < nurbs.topology.vectors)
  {
    scanner.Fail("the edges have " + std::to_string(nurbs.topology.vectors) +
      " knot vectors, but the file lists " + std::to_string(count) + ".");
  }
  for (int i = 0; i < count; ++i)
  {
    nurbs.vectors.push_back(ReadKnotVector(scanner));
  }
}

/// Throws where nodes or weights are missing for some control points.
void RequireNodes(TextScanner& scanner, const NurbsMesh& nurbs, const GridFunctionFile& nodes)
{
  const std::int64_t size = ControlPoints(nurbs).Size();
  const auto values = static_cast<std::int64_t>(nodes.values.size());
  const std::int64_t most = nurbs.masters.empty() ? values : kMaxIdentified * values;
  const auto weights = static_cast<std::int64_t>(nurbs.weights.size());
  if (size > std::min(std::max(most, weights), kMaxControlPoints))
  {
    scanner.Fail("the nodes hold " + std::to_string(values) +
      " values, but the knot vectors have " + std::to_string(size) +
      " control points; the file is cut short or damaged.");
  }
  if (weights > 0 && weights != size)
  {
    scanner.Fail("there are " + std::to_string(weights) + " weights for " + std::to_string(size) +
      " control points.");
  }
}

void ReadWeights(TextScanner& scanner, NurbsMesh& nurbs)
{
  const std::string_view word = scanner.Word("the weights");
  if (word == "unitweights" || word == "autoweights")
  {
    return;
  }
  if (word != "weights")
  {
    scanner.Fail("'" + std::string(word.substr(0, 40)) +
      "' stands where 'weights' should; the file is damaged.");
  }
  double weight = 0.0;
  while (scanner.TryNumber(weight))
  {
    nurbs.weights.push_back(weight);
  }
  RequirePositive(scanner, nurbs.weights);
}
} // namespace

MeshFile ReadNurbs(TextScanner& scanner, bool hasSpacing)
{
  auto nurbs = std::make_shared<NurbsMesh>();
  nurbs->topology = ReadPatchTopology(scanner);
  std::optional<GridFunctionFile> nodes;
  const std::string_view form = scanner.Word("'knotvectors' or 'patches'");
  if (form == "patches")
  {
    nodes = ReadPatches(scanner, *nurbs);
  }
  else if (form != "knotvectors")
  {
    scanner.Fail("'" + std::string(form.substr(0, 40)) +
      "' stands where 'knotvectors' or 'patches' should; the file is damaged.");
  }
  else
  {
    ReadKnotVectors(scanner, *nurbs);
    if (hasSpacing)
    {
      SkipSpacing(scanner, *nurbs);
    }
    if (scanner.Peek() == "mesh_elements")
    {
      scanner.Word("mesh_elements");
      nurbs->pieces.push_back(ReadList(scanner, "the elements of the piece"));
      std::ranges::sort(nurbs->pieces.front());
    }
    if (scanner.Peek() == "periodic")
    {
      scanner.Word("periodic");
      nurbs->masters = ReadList(scanner, "the boundaries that are identified");
      nurbs->slaves = ReadList(scanner, "the boundaries that are identified");
    }
    ReadWeights(scanner, *nurbs);
    nodes = ReadGridFunction(scanner);
  }
  MeshFile mesh;
  if (nurbs->pieces.empty())
  {
    RequireNodes(scanner, *nurbs, *nodes);
    mesh = MakeNurbsMesh(*nurbs);
  }
  mesh.dimension = nurbs->topology.dimension;
  mesh.nodes = std::move(nodes);
  mesh.nurbs = std::move(nurbs);
  if (scanner.Peek() == "mfem_mesh_end")
  {
    scanner.Word("the end of the mesh");
  }
  return mesh;
}

MeshFile MakeNurbsMesh(NurbsMesh& nurbs)
{
  std::vector<int> counts;
  std::ranges::transform(nurbs.vectors, std::back_inserter(counts),
    [](const KnotVector& v) { return static_cast<int>(v.Spans().size()) + 1; });
  const PatchNumbering vertices(nurbs.topology, std::move(counts));
  return MakeGridMesh(nurbs.topology, vertices, nurbs.places);
}
} // namespace pixelexact::mfem
