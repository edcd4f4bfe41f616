// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/Views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace pixelexact::gmsh
{
namespace
{
struct KindName
{
  const char* section;
  ViewKind kind;
};
constexpr std::array kKinds{
  KindName{ "NodeData", ViewKind::Node },
  KindName{ "ElementData", ViewKind::Element },
  KindName{ "ElementNodeData", ViewKind::ElementNode },
};

const char* SectionOf(ViewKind kind)
{
  return std::ranges::find(kKinds, kind, &KindName::kind)->section;
}

struct Head
{
  std::string name;
  std::int64_t step = 0;
  ViewPart part;
};

Head ReadHead(Scanner& scanner)
{
  Head head;
  const std::size_t strings = scanner.TextCount("the number of string tags", 2);
  for (std::size_t i = 0; i < strings; ++i)
  {
    std::string text = scanner.QuotedOrLine("a string tag of a view");
    if (i < 2)
    {
      (i == 0 ? head.name : head.part.schemeName) = std::move(text);
    }
  }
  const std::size_t reals = scanner.TextCount("the number of real tags", 2);
  for (std::size_t i = 0; i < reals; ++i)
  {
    const double value = scanner.TextNumber("a real tag of a view");
    head.part.time = i == 0 ? value : head.part.time;
  }
  if (!std::isfinite(head.part.time))
  {
    scanner.Fail("the time of the view '" + head.name + "' is not a finite number.");
  }
  const std::size_t integers = scanner.TextCount("the number of integer tags", 2);
  if (integers < 3)
  {
    scanner.Fail("the view '" + head.name + "' has " + std::to_string(integers) +
      " integer tags; it needs three: time step, components, number of values.");
  }
  head.step = scanner.TextInteger("a time step");
  const std::int64_t components = scanner.TextInteger("a number of components");
  if (components != 1 && components != 3 && components != 9)
  {
    scanner.Fail("the view '" + head.name + "' has " + std::to_string(components) +
      " components; Gmsh knows 1, 3 and 9.");
  }
  head.part.components = static_cast<int>(components);
  head.part.count = scanner.TextCount("the number of a view's values", 4);
  for (std::size_t i = 3; i < integers; ++i)
  {
    const std::int64_t value = scanner.TextInteger("an integer tag of a view");
    head.part.partition = i == 3 ? static_cast<int>(value) : head.part.partition;
  }
  scanner.EndLine();
  head.part.values = scanner.Position();
  return head;
}

Interpolation ReadMatrices(Scanner& scanner, const std::string& scheme, int dimension)
{
  const auto count = scanner.TextInteger("the number of interpolation matrices");
  if (count != 2)
  {
    scanner.FailUnsupported("the interpolation scheme '" + scheme + "' has " +
      std::to_string(count) +
      " matrices for one shape; two are read: coefficients and exponents (the geometry is the "
      "mesh's).");
  }
  Interpolation interpolation;
  const std::size_t n = scanner.TextCount("the rows of a matrix", 2);
  if (scanner.TextCount("the columns of a matrix", 2) != n || n == 0)
  {
    scanner.Fail(
      "the coefficients of the interpolation scheme '" + scheme + "' are no square matrix.");
  }
  interpolation.functions = static_cast<int>(n);
  for (std::size_t i = 0; i < n * n; ++i)
  {
    interpolation.coefficients.push_back(scanner.TextNumber("a coefficient"));
  }
  // One column for each of u, v, w. Lines, triangles and quadrilaterals have fewer.
  const bool matches = scanner.TextCount("the rows of a matrix", 2) == n;
  const std::size_t columns = scanner.TextCount("the columns of a matrix", 2);
  if (!matches || columns > 3 || columns < static_cast<std::size_t>(dimension))
  {
    scanner.Fail("the exponents of the interpolation scheme '" + scheme + "' are not " +
      (dimension == 3 ? "three" : "two or three") + " for each of its " + std::to_string(n) +
      " functions.");
  }
  for (std::size_t i = 0; i < columns * n; ++i)
  {
    const double exponent = scanner.TextNumber("an exponent");
    if (!(exponent >= 0.0 && exponent <= kMaxOrder && exponent == std::floor(exponent)))
    {
      scanner.Fail("an exponent of the interpolation scheme '" + scheme +
        "' is no whole number from 0 to " + std::to_string(kMaxOrder) + ".");
    }
    interpolation.exponents.push_back(static_cast<int>(exponent));
    const bool isLast = (i + 1) % columns == 0;
    if (dimension == 2 && isLast && columns == 3 && exponent > 0.0)
    {
      scanner.Fail("the interpolation scheme '" + scheme +
        "' has functions of w on triangles or quadrilaterals, where w is 0.");
    }
    if (dimension == 2 && isLast && columns == 2)
    {
      interpolation.exponents.push_back(0);
    }
  }
  return interpolation;
}

/// The dimension and shape of Gmsh's number for a family of elements.
std::optional<std::pair<int, Shape>> ShapeOf(std::int64_t topology)
{
  switch (topology)
  {
    case 3:
      return std::pair(2, Shape::Prism);
    case 4:
      return std::pair(2, Shape::Hexahedron);
    case 5:
      return std::pair(3, Shape::Tetrahedron);
    case 6:
      return std::pair(3, Shape::Pyramid);
    case 7:
      return std::pair(3, Shape::Prism);
    case 8:
      return std::pair(3, Shape::Hexahedron);
    default:
      return std::nullopt;
  }
}

void ReadPart(Scanner& scanner, const View& view, const ViewPart& part, const MeshFile& mesh,
  ViewValues& values)
{
  scanner.MoveTo(part.values);
  const TagIndex& index = view.kind == ViewKind::Node ? mesh.nodeOf : mesh.elementOf;
  const auto components = static_cast<std::size_t>(part.components);
  for (std::size_t i = 0; i < part.count; ++i)
  {
    const auto tag = static_cast<std::uint32_t>(scanner.Int("the number of a value's place"));
    std::size_t tuples = 1;
    if (view.kind == ViewKind::ElementNode)
    {
      const int count = scanner.Int("the number of an element's values");
      if (count < 1 || static_cast<std::size_t>(count) > scanner.Remaining() / 2)
      {
        scanner.Fail("element " + std::to_string(tag) + " has " + std::to_string(count) +
          " values; the file is damaged.");
      }
      tuples = static_cast<std::size_t>(count);
    }
    const std::int32_t place = index.Find(tag);
    if (place < 0)
    {
      // The element belongs to a surface or curve, or not to this mesh.
      ++values.strangers;
      scanner.SkipReals(tuples * components);
      continue;
    }
    if (values.first[place] < 0)
    {
      values.first[place] = static_cast<std::int64_t>(values.values.size());
      values.values.resize(values.values.size() + tuples * components);
      if (!values.count.empty())
      {
        values.count[place] = static_cast<std::int32_t>(tuples);
      }
    }
    else if (!values.count.empty() && values.count[place] != static_cast<std::int32_t>(tuples))
    {
      scanner.Fail("element " + std::to_string(tag) + " has values twice, of different number.");
    }
    for (std::size_t k = 0; k < tuples * components; ++k)
    {
      values.values[static_cast<std::size_t>(values.first[place]) + k] =
        scanner.Real("a value of a view");
    }
  }
  scanner.EndSection(SectionOf(view.kind));
}
} // namespace

std::optional<ViewKind> KindOf(const std::string& section)
{
  const auto* found = std::ranges::find(kKinds, section, &KindName::section);
  return found == kKinds.end() ? std::nullopt : std::optional(found->kind);
}

void ViewList::AddHead(
  Scanner& scanner, std::size_t file, std::size_t pieces, ViewKind kind, const std::string& unnamed)
{
  Head head = ReadHead(scanner);
  head.part.file = file;
  if (!head.part.schemeName.empty())
  {
    const auto scheme = Known.find(head.part.schemeName);
    if (scheme == Known.end())
    {
      scanner.Fail("the view '" + head.name + "' has the interpolation scheme '" +
        head.part.schemeName + "', which no $InterpolationScheme before it defines.");
    }
    head.part.scheme = scheme->second;
  }
  const std::string name = head.name.empty() ? unnamed : head.name;
  auto view = std::ranges::find(All, name, &View::name);
  if (view == All.end())
  {
    All.push_back({ name, kind, {} });
    view = All.end() - 1;
  }
  if (view->kind != kind)
  {
    scanner.Fail("there are two views of the name '" + name + "', one in $" +
      SectionOf(view->kind) + " and one in $" + SectionOf(kind) + "; rename one of them.");
  }
  auto& parts = view->steps[head.step];
  for (const ViewPart& other : parts)
  {
    const bool areParts = other.file != file && other.file < pieces && file < pieces;
    if (other.partition == head.part.partition && !areParts)
    {
      scanner.Fail("the view '" + name + "' is there twice at step " + std::to_string(head.step) +
        "; where these are two views, rename one of them.");
    }
    if (other.components != head.part.components || other.schemeName != head.part.schemeName)
    {
      scanner.Fail("the partitions of the view '" + name + "' at step " +
        std::to_string(head.step) + " differ in components or interpolation scheme.");
    }
  }
  parts.push_back(std::move(head.part));
}

void ViewList::AddScheme(Scanner& scanner)
{
  const std::string name = scanner.Quoted("the name of an interpolation scheme");
  const std::size_t shapes = scanner.TextCount("the number of element topologies", 2);
  Scheme scheme;
  for (std::size_t i = 0; i < shapes; ++i)
  {
    const auto shape = ShapeOf(scanner.TextInteger("an element topology"));
    Interpolation matrices = ReadMatrices(scanner, name, shape ? shape->first : 0);
    if (shape)
    {
      scheme[*shape] = std::move(matrices);
    }
  }
  scanner.EndSection("InterpolationScheme");
  // Gmsh writes one scheme for each view, all with the same name.
  Known[name] = std::make_shared<const Scheme>(std::move(scheme));
}

StepList StepsOf(const std::vector<View>& views)
{
  std::map<std::int64_t, std::set<double>> timesOf;
  for (const View& view : views)
  {
    for (const auto& [number, parts] : view.steps)
    {
      for (const ViewPart& part : parts)
      {
        timesOf[number].insert(part.time);
      }
    }
  }
  StepList steps;
  for (const auto& [number, times] : timesOf)
  {
    steps.numbers.push_back(number);
    steps.numbered |=
      times.size() > 1 || (!steps.times.empty() && *times.begin() <= steps.times.back());
    steps.times.push_back(*times.begin());
  }
  if (steps.numbered)
  {
    steps.times.assign(steps.numbers.begin(), steps.numbers.end());
  }
  if (steps.times.size() == 1 && (steps.times[0] == 0.0 || steps.numbered))
  {
    steps.times.clear();
  }
  return steps;
}

ViewValues ReadValues(std::vector<Scanner>& scanners, const View& view,
  const std::vector<ViewPart>& parts, const MeshFile& mesh)
{
  ViewValues values;
  values.components = parts.front().components;
  values.first.assign(view.kind == ViewKind::Node ? mesh.nodes : mesh.elements.size(), -1);
  if (view.kind == ViewKind::ElementNode)
  {
    values.count.assign(mesh.elements.size(), 0);
  }
  for (const ViewPart& part : parts)
  {
    ReadPart(scanners[part.file], view, part, mesh, values);
  }
  return values;
}
} // namespace pixelexact::gmsh
