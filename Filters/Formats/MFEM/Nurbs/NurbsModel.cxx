// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Nurbs/NurbsModel.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Basis/Space.h"
#include "Formats/Assembly.h"
#include "Formats/FileText.h"
#include "Formats/MFEM/Nurbs/ForParts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace pixelexact::mfem
{
namespace
{
/// A knot span whose map needs a higher order is divided. For a ray, two parts of sufficient order
/// cost less than one part of the higher order.
constexpr int kMaxMapOrder = 12;
/// The limit where kMaxMapOrder would give too many parts.
constexpr int kHighMapOrder = 18;
/// Fields are defined on the map's parts. Two further orders are needed to check that the order
/// suffices.
constexpr int kMaxFieldOrder = kMaxOrder - 2;
/// Largest loss of a field, relative to its range. A larger one is refused.
constexpr double kMaxFieldLoss = 1e-9;

std::string Text(double number)
{
  std::ostringstream text;
  text.precision(2);
  text << number;
  return text.str();
}

/// The largest range of one component's values.
double RangeOf(std::span<const double> values, int components)
{
  double range = 0.0;
  for (int c = 0; c < components; ++c)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (auto at = static_cast<std::size_t>(c); at < values.size();
         at += static_cast<std::size_t>(components))
    {
      low = std::min(low, values[at]);
      high = std::max(high, values[at]);
    }
    range = std::max(range, high - low);
  }
  return range;
}

/// Knot vectors that MFEM 4.9 reverses, because it orients a patch's edges from its first vertex.
std::set<int> TurnedByOthers(const NurbsMesh& mesh)
{
  std::set<int> turned;
  for (std::size_t p = 0; p < mesh.topology.patches.size(); ++p)
  {
    const Cell& patch = mesh.topology.patches[p];
    for (int d = 0; d < mesh.topology.dimension; ++d)
    {
      std::array<int, 3> ends{};
      ends.at(d) = 1;
      const int edge = mesh.topology.FindEdge(patch.vertices[0], patch.vertices.at(CornerAt(ends)));
      const int vector = mesh.topology.lines[p].at(d).vector;
      if (mesh.topology.listedDownwards.contains(edge) &&
        !mesh.vectors[static_cast<std::size_t>(vector)].IsSymmetric())
      {
        turned.insert(vector);
      }
    }
  }
  return turned;
}
} // namespace

NurbsModel::NurbsModel(
  const MeshFile& file, std::span<const GridFunctionFile> nodes, std::span<const std::string> names)
  : File(file)
  , Mesh(*file.nurbs)
  , Name(names.front())
{
  for (std::size_t p = 0; p < Mesh.pieces.size(); ++p)
  {
    PieceOf.resize(File.elements.size());
    for (const int element : Mesh.pieces[p])
    {
      PieceOf[static_cast<std::size_t>(element)] = static_cast<int>(p);
    }
  }
  for (const KnotVector& vector : Mesh.vectors)
  {
    PartsOfSpan.emplace_back(vector.Spans().size(), 1);
  }
  MakeParts();
  if (!nodes.empty())
  {
    std::vector<std::string> where;
    std::ranges::transform(names, std::back_inserter(where),
      [](const std::string& own) { return own + ": the mesh's nodes"; });
    Map.emplace(FunctionOf(nodes, where));
    if (!Map->data.isOne)
    {
      throw InvalidData(Name +
        ": pieces of the mesh have control points at different places where "
        "they meet; they are of different runs: remove what an earlier one "
        "has left.");
    }
    const int components = Map->components;
    if (components < File.dimension || components > 3)
    {
      throw InvalidData(Name + ": the mesh's nodes are no positions: they need VDim " +
        (File.dimension == 2 ? "2 or 3." : "3."));
    }
    if (!Divide(*Map, kMaxMapOrder) && !Divide(*Map, kHighMapOrder))
    {
      throw Unsupported(Name + ": the weights of a knot span differ so much that polynomials on " +
        std::to_string(kMaxParts) +
        " parts of it do not come near its map; refit it with weights that are more alike.");
    }
  }
  DrawnEntities.emplace(Drawn);
}

NurbsModel::Function NurbsModel::FunctionOf(
  std::span<const GridFunctionFile> files, std::span<const std::string> names) const
{
  const GridFunctionFile& file = files.front();
  const auto readWhole = [&]
  {
    NurbsSpace space(Mesh, file);
    std::vector<double> values = space.ValuesOf(file);
    return PiecedFunction{ std::move(space), std::move(values), {}, {}, true };
  };
  PiecedFunction data =
    PieceOf.empty() ? NameErrors(names.front(), readWhole) : ReadPieces(Mesh, files, names);
  if (!std::ranges::all_of(data.values, [](double v) { return std::isfinite(v); }))
  {
    throw InvalidData(names.front() +
      ": a control point has a value that is NaN or infinite, which spoils all elements around it; "
      "write the file again.");
  }
  return { std::move(data), file.components };
}

rational::RationalElement NurbsModel::ElementOf(const Function& function, std::size_t part) const
{
  const rational::ElementPart& own = PartList[part];
  const auto element = static_cast<std::size_t>(own.element);
  const PiecedFunction& data = function.data;
  std::span<const double> values = data.values;
  std::span<const int> rows;
  if (!PieceOf.empty())
  {
    const auto piece = static_cast<std::size_t>(PieceOf[element]);
    values = values.subspan(data.first[piece] * static_cast<std::size_t>(function.components));
    rows = data.points[piece];
  }
  return data.space.ElementOf(Mesh.places[element], own, values, function.components, rows);
}

NurbsModel::Bases NurbsModel::BasesOf(
  const Function& function, int most, const std::function<double(std::size_t)>& target)
{
  const std::size_t parts = PartList.size();
  std::vector<rational::Orders> needed(parts);
  ForParts(parts,
    [&](std::size_t i)
    {
      const rational::RationalElement element = ElementOf(function, i);
      const rational::OrderEstimate estimate =
        rational::EstimateOrders(element, target(i), most, Tables);
      for (std::size_t d = 0; d < 3; ++d)
      {
        needed[i][d] = estimate.order ? (*estimate.order)[d] : element.degree[d] == 0 ? 0 : most;
      }
    });
  std::vector<int> ofVector(Mesh.vectors.size(), 0);
  const auto lineOf = [&](std::size_t i, int d)
  {
    const GridPlace& place = Mesh.places[static_cast<std::size_t>(PartList[i].element)];
    return static_cast<std::size_t>(Mesh.topology.lines[place.patch].at(d).vector);
  };
  for (std::size_t i = 0; i < parts; ++i)
  {
    for (int d = 0; d < Mesh.topology.dimension; ++d)
    {
      ofVector[lineOf(i, d)] = std::max(ofVector[lineOf(i, d)], needed[i].at(d));
    }
  }
  Bases bases;
  bases.order.resize(parts);
  for (std::size_t i = 0; i < parts; ++i)
  {
    Space space{ Shape::Hexahedron, Form::Collapsed, { 0, 0, 0 } };
    for (int d = 0; d < Mesh.topology.dimension; ++d)
    {
      bases.order[i].at(d) = ofVector[lineOf(i, d)];
      space.order.at(d) = static_cast<std::uint8_t>(bases.order[i].at(d));
    }
    auto known = KnownBases.find(space);
    if (known == KnownBases.end())
    {
      std::vector<int> source(static_cast<std::size_t>(space.Modes()));
      std::iota(source.begin(), source.end(), 0);
      ElementBasis made;
      made.sources = space.Modes();
      made.parts.push_back(ChangeOfBasis::Hexahedron(space, Family::GaussLobattoLagrange, source));
      known = KnownBases.emplace(space, std::move(made)).first;
    }
    bases.basis.push_back(&known->second);
  }
  bases.loss.resize(parts);
  ForParts(parts,
    [&](std::size_t i)
    { bases.loss[i] = rational::LossOf(ElementOf(function, i), bases.order[i], Tables); });
  bases.isPolynomial = std::ranges::all_of(bases.loss, [](double loss) { return loss == 0.0; });
  return bases;
}

void NurbsModel::AddMap(SolverModel& model)
{
  const Function& function = *Map;
  const Bases bases = BasesOf(function, MapOrder,
    [this](std::size_t i)
    { return kLoss * Extent[static_cast<std::size_t>(PartList[i].element)]; });
  const auto gather = [&](std::size_t i, std::span<double> values)
  { rational::NodeValues(ElementOf(function, i), bases.order[i], Tables, values); };
  const auto describe = [this](std::size_t i)
  { return Name + ": element " + std::to_string(PartList[i].element); };
  if (Mesh.topology.dimension == 3)
  {
    AssembleMap(bases.basis, gather, describe, model.mesh);
  }
  else
  {
    AssemblePlaneMap(bases.basis, function.components, gather, describe, model.mesh);
  }
  for (const int vector : TurnedByOthers(Mesh))
  {
    model.notes.push_back(Name + ": knot vector " + std::to_string(vector) +
      " is not symmetric, and the file lists edges of it from their higher vertex: it is read as "
      "MFEM to 4.8 does; MFEM 4.9 turns it.");
  }
  if (bases.isPolynomial)
  {
    return;
  }
  double relative = 0.0;
  for (std::size_t i = 0; i < bases.loss.size(); ++i)
  {
    model.mesh.uncertainty[i] += bases.loss[i];
    const double extent = Extent[static_cast<std::size_t>(PartList[i].element)];
    relative = std::max(relative, extent > 0.0 ? bases.loss[i] / extent : 0.0);
  }
  model.notes.push_back(Name + ": " + Counted(File.elements.size(), "knot span") + " as " +
    Counted(PartList.size(), "element") +
    " with polynomials in place of rational maps, which are proven to lose at most " +
    Text(relative) + " of a span's size, " + Text(*std::ranges::max_element(bases.loss)) +
    "; verdicts take that into account.");
}

void NurbsModel::AddField(std::span<const GridFunctionFile> files,
  std::span<const std::string> names, const std::string& name, SolverModel& model)
{
  const std::string& where = names.front();
  const Function function = FunctionOf(files, names);
  const double range = RangeOf(function.data.values, function.components);
  const Bases bases = BasesOf(function, kMaxFieldOrder, [&](std::size_t) { return kLoss * range; });
  const double loss = *std::ranges::max_element(bases.loss);
  if (loss > kMaxFieldLoss * range)
  {
    throw Unsupported(where + ": its weights differ so much that polynomials of order " +
      std::to_string(kMaxFieldOrder) +
      " do not come near it; refit it with weights that are more alike, or with those of the "
      "mesh.");
  }
  SolverField field;
  field.name = name;
  field.basis = function.data.space.Description();
  field.continuous = function.data.space.IsContinuous() && function.data.isOne;
  field.values = AssembleField(bases.basis, function.components,
    [&](std::size_t i, std::span<double> values)
    { rational::NodeValues(ElementOf(function, i), bases.order[i], Tables, values); });
  if (!bases.isPolynomial)
  {
    model.notes.push_back(where +
      ": polynomials in place of rational functions, which are proven to lose at most " +
      Text(loss) +
      (range > 0.0 ? " (" + Text(loss / range) + " of the coefficients' range)." : "."));
  }
  model.fields.push_back(std::move(field));
}
} // namespace pixelexact::mfem
