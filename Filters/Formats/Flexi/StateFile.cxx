// SPDX-License-Identifier: BSD-3-Clause
// Names of data sets and attributes are facts from FLEXI's user guide and from its output
// (github.com/flexi-framework/flexi). A Fortran array (variable, i, j, k, element) has the element
// as the first direction in the file.
#include "Formats/Flexi/StateFile.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Element/ElementUnits.h"
#include "Formats/Assembly.h"
#include "Formats/Hdf5/Hdf5File.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <set>

namespace pixelexact::flexi
{
namespace
{
constexpr std::size_t kMaxNodes = 33; ///< along a direction
constexpr const char* kSolution = "/DG_Solution";
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void RefuseState(const std::string& name, const std::string& why)
{
  throw InvalidData(name + ": " + why + "; the state is damaged: write or copy it again.");
}

std::vector<std::string> TextsOf(const Hdf5File& state, const char* attribute)
{
  auto texts = state.HasAttribute("/", attribute) ? state.TextAttributes("/", attribute)
                                                  : std::vector<std::string>();
  std::ranges::transform(texts, texts.begin(), &PlainText);
  return texts;
}

std::string TextOf(const Hdf5File& state, const char* attribute)
{
  const auto texts = TextsOf(state, attribute);
  return texts.empty() ? std::string() : texts.front();
}

Nodes NodesOf(const Hdf5File& state, const std::string& name)
{
  const std::string type = TextOf(state, "NodeType");
  if (type == "GAUSS")
  {
    return Nodes::Gauss;
  }
  if (type == "GAUSS-LOBATTO")
  {
    return Nodes::GaussLobatto;
  }
  throw Unsupported(name + ": the nodes of its elements (NodeType) are of type '" + type +
    "'; GAUSS and GAUSS-LOBATTO are read: interpolate to these.");
}

/// The names of variables; those that are missing are numbers.
std::vector<std::string> NamesOf(
  const Hdf5File& state, const char* attribute, const std::string& other, std::size_t count)
{
  std::vector<std::string> names = TextsOf(state, attribute);
  names.resize(count);
  for (std::size_t v = 0; v < count; ++v)
  {
    if (names[v].empty())
    {
      names[v] = other + std::to_string(v + 1);
    }
  }
  return names;
}

ElementBasis BasisOf(const StateHead& head)
{
  const auto line = [&head](int count)
  {
    return Lagrange(
      head.nodes == Nodes::Gauss || count == 1 ? GaussPoints(count) : GaussLobattoPoints(count));
  };
  Space space = UniformSpace(Shape::Hexahedron, 1);
  space.order[0] = space.order[1] = static_cast<std::uint8_t>(head.count - 1);
  space.order[2] = static_cast<std::uint8_t>(head.across - 1);
  const int n = head.count;
  std::vector<int> source;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int k = 0; k < head.across; ++k)
      {
        source.push_back(i + n * (j + n * k));
      }
    }
  }
  ElementBasis basis;
  basis.parts.push_back(
    ChangeOfBasis::FromLines(space, { line(n), line(n), line(head.across) }, source));
  basis.sources = n * n * head.across;
  return basis;
}

/// Constants on hexahedra.
ElementBasis ConstantBasis()
{
  ElementBasis basis;
  const std::vector<int> source{ 0 };
  basis.parts.push_back(ChangeOfBasis::Hexahedron(
    UniformSpace(Shape::Hexahedron, 0), Family::EquispacedLagrange, source));
  basis.sources = 1;
  return basis;
}

/// Adds the fields of one state.
class FieldAdder
{
public:
  FieldAdder(
    const Hdf5File& state, const StateHead& head, const std::string& name, SolverModel& model)
    : State(state)
    , Head(head)
    , Name(name)
    , Model(model)
  {
    const bool isGauss = head.nodes == Nodes::Gauss;
    Description = isGauss ? "FLEXI, Gauss-Legendre nodes" : "FLEXI, Gauss-Lobatto-Legendre nodes";
  }

  void AddAll()
  {
    FindVolumes();
    const ElementBasis basis = BasisOf(Head);
    AddSet(kSolution, Head.variables, basis, Description, true);
    if (State.Has("/FieldData"))
    {
      AddFieldData(basis);
    }
    if (State.Has("/ElemData"))
    {
      AddElementData();
    }
    NoteOthers();
  }

private:
  [[nodiscard]] std::size_t Nodes() const
  {
    return static_cast<std::size_t>(Head.count) * static_cast<std::size_t>(Head.count) *
      static_cast<std::size_t>(Head.across);
  }

  /// Finds elements whose values are means of finite volumes.
  void FindVolumes()
  {
    const std::vector<std::size_t> shape =
      State.Has("/ElemData") ? State.Shape("/ElemData") : std::vector<std::size_t>();
    const auto names = TextsOf(State, "VarNamesAdd");
    const auto place = std::ranges::find(names, "FV_Elems");
    const auto column = static_cast<std::size_t>(place - names.begin());
    if (place == names.end() || !IsElementData(shape) || column >= shape[1])
    {
      return;
    }
    const std::vector<double> values = State.Reals("/ElemData");
    IsVolume.resize(static_cast<std::size_t>(Head.elements));
    for (std::size_t e = 0; e < IsVolume.size(); ++e)
    {
      IsVolume[e] = values[e * shape[1] + column] != 0.0;
    }
    if (const auto count = std::ranges::count(IsVolume, true); count > 0)
    {
      Model.notes.push_back(Name + ": " + std::to_string(count) + " of " +
        Counted(Head.elements, "element") +
        " hold means of finite volumes (FV_Elems), not polynomials; the fields are NaN there.");
    }
  }

  [[nodiscard]] bool IsElementData(const std::vector<std::size_t>& shape) const
  {
    return shape.size() == 2 && shape[0] == static_cast<std::size_t>(Head.elements);
  }

  /// Adds each variable of a data set, the last direction of which is the variables.
  void AddSet(const std::string& path, const std::vector<std::string>& names,
    const ElementBasis& basis, const std::string& description, bool areNodes)
  {
    const std::vector<double> values = State.Reals(path);
    const std::size_t variables = names.size();
    const auto nodes = static_cast<std::size_t>(basis.sources);
    const auto elements = static_cast<std::size_t>(Head.elements);
    if (values.size() != elements * nodes * variables)
    {
      RefuseState(Name, path.substr(1) + " has another number of values than its shape");
    }
    const std::vector<const ElementBasis*> bases(elements, &basis);
    for (std::size_t v = 0; v < variables; ++v)
    {
      if (!Known.insert(names[v]).second)
      {
        Model.notes.push_back(Name + ": '" + names[v] + "' of " + path.substr(1) +
          " has the name of another field and is left out.");
        continue;
      }
      std::atomic<std::size_t> undefined = 0;
      SolverField field;
      field.name = names[v];
      field.basis = description;
      field.values = AssembleField(bases, 1,
        [&](std::size_t e, std::span<double> source)
        {
          for (std::size_t node = 0; node < nodes; ++node)
          {
            source[node] = values[(e * nodes + node) * variables + v];
          }
          const bool isVolume = areNodes && !IsVolume.empty() && IsVolume[e];
          const bool isFinite =
            std::ranges::all_of(source, [](double value) { return std::isfinite(value); });
          undefined += isFinite ? 0 : 1;
          if (isVolume || !isFinite)
          {
            std::ranges::fill(source, kNone);
          }
        });
      NoteUndefined(names[v], undefined);
      Model.fields.push_back(std::move(field));
    }
  }

  void NoteUndefined(const std::string& field, std::size_t count)
  {
    if (count > 0)
    {
      Model.notes.push_back(Name + ": the field '" + field + "' is NaN or infinite at nodes of " +
        std::to_string(count) + " of " + Counted(Head.elements, "element") +
        "; it is NaN there. Where the run has diverged, use an earlier state.");
    }
  }

  void AddFieldData(const ElementBasis& basis)
  {
    const std::vector<std::size_t> shape = State.Shape("/FieldData");
    const auto n = static_cast<std::size_t>(Head.count);
    const std::vector<std::size_t> expected{ static_cast<std::size_t>(Head.elements),
      static_cast<std::size_t>(Head.across), n, n };
    if (shape.size() != 5 || !std::equal(expected.begin(), expected.end(), shape.begin()))
    {
      Model.notes.push_back(
        Name + ": FieldData has other nodes or elements than DG_Solution and is left out.");
      return;
    }
    AddSet("/FieldData", NamesOf(State, "VarNamesAddField", "FieldData", shape[4]), basis,
      Description, true);
  }

  void AddElementData()
  {
    const std::vector<std::size_t> shape = State.Shape("/ElemData");
    if (!IsElementData(shape))
    {
      Model.notes.push_back(
        Name + ": ElemData has other elements than DG_Solution and is left out.");
      return;
    }
    AddSet("/ElemData", NamesOf(State, "VarNamesAdd", "ElemData", shape[1]), ConstantBasis(),
      "FLEXI, a value per element", false);
  }

  void NoteOthers()
  {
    const std::set<std::string> known{ "DG_Solution", "FieldData", "ElemData" };
    std::string others;
    for (const std::string& name : State.Names("/"))
    {
      if (!known.contains(name))
      {
        others += (others.empty() ? "'" : ", '") + name + "'";
      }
    }
    if (!others.empty())
    {
      Model.notes.push_back(Name + ": " + others +
        (others.find(',') == std::string::npos ? " is" : " are") +
        " left out; DG_Solution, FieldData and ElemData are read.");
    }
  }

  const Hdf5File& State;
  const StateHead& Head;
  const std::string& Name;
  SolverModel& Model;
  std::string Description;
  std::set<std::string> Known;
  std::vector<bool> IsVolume;
};
} // namespace

std::string PlainText(const std::string& text)
{
  const auto begin = text.find_first_not_of(' ');
  const auto end = text.find_last_not_of(' ');
  std::string plain = begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
  std::ranges::replace_if(
    plain, [](char c) { return c < ' ' || c > '~'; }, '?');
  return plain;
}

bool IsState(const Hdf5File& file)
{
  return file.Has(kSolution);
}

StateHead ReadHead(const Hdf5File& state, const std::string& name)
{
  StateHead head;
  head.nodes = NodesOf(state, name);
  const std::vector<std::size_t> shape = state.Shape(kSolution);
  if (shape.size() != 5 || shape[0] == 0 || shape[2] != shape[3] || shape[4] == 0 ||
    (shape[1] != shape[3] && shape[1] != 1))
  {
    RefuseState(name, "DG_Solution does not have the directions element, k, j, i and variable");
  }
  const std::size_t least = head.nodes == Nodes::Gauss ? 1 : 2;
  if (shape[3] < least || shape[3] > kMaxNodes)
  {
    throw Unsupported(name + ": its elements have " + Counted(shape[3], "node") +
      " along a direction; " + std::to_string(least) + " to " + std::to_string(kMaxNodes) +
      " are read.");
  }
  if (state.HasAttribute("/", "N"))
  {
    const auto order = state.IntegerAttributes("/", "N");
    if (order.empty() || order[0] + 1 != static_cast<std::int64_t>(shape[3]))
    {
      RefuseState(name, "its order N is not that of DG_Solution");
    }
  }
  const auto time = state.RealAttributes("/", "Time");
  if (time.empty() || !std::isfinite(time[0]))
  {
    RefuseState(name, "its Time is not a number");
  }
  head.elements = static_cast<std::int64_t>(shape[0]);
  head.across = static_cast<int>(shape[1]);
  head.count = static_cast<int>(shape[3]);
  head.time = time[0];
  head.mesh = TextOf(state, "MeshFile");
  head.variables = NamesOf(state, "VarNames", "variable", shape[4]);
  return head;
}

void ReadFields(
  const Hdf5File& state, const StateHead& head, const std::string& name, SolverModel& model)
{
  FieldAdder(state, head, name, model).AddAll();
}
} // namespace pixelexact::flexi
