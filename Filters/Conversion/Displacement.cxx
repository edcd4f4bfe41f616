// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Displacement.h"

#include "Conversion/ConvertedGrid.h"
#include "Conversion/FieldSum.h"
#include "Core/Base/Error.h"
#include "Grids/Continuity.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

namespace pixelexact
{
namespace
{
/// Definitions that name each other in a circle end here.
constexpr int kMaxDefinitions = 64;

std::string Trimmed(std::string text)
{
  const auto isBlank = [](unsigned char c) { return std::isspace(c) != 0; };
  text.erase(text.begin(), std::ranges::find_if_not(text, isBlank));
  while (!text.empty() && isBlank(static_cast<unsigned char>(text.back())))
  {
    text.pop_back();
  }
  return text;
}

/// The arguments of vec(...); none where the text is something else.
std::vector<std::string> ArgumentsOfVec(const std::string& text)
{
  const bool isVec =
    text.starts_with("vec") && Trimmed(text.substr(3)).starts_with("(") && text.ends_with(")");
  if (!isVec)
  {
    return {};
  }
  const std::size_t open = text.find('(');
  std::vector<std::string> arguments(1);
  char quote = 0;
  for (const char c : text.substr(open + 1, text.size() - open - 2))
  {
    if (c == ',' && quote == 0)
    {
      arguments.emplace_back();
      continue;
    }
    quote = c == quote ? 0 : quote == 0 && (c == '"' || c == '\'') ? c : quote;
    arguments.back() += c;
  }
  std::ranges::transform(arguments, arguments.begin(), &Trimmed);
  return arguments;
}

/// Returns the definition that a calculator gave the name, else the text itself.
std::string Resolved(const HighOrderModel& model, const std::string& text)
{
  std::string resolved = Trimmed(text);
  for (int k = 0; k < kMaxDefinitions; ++k)
  {
    const auto defined = model.Definitions().find(resolved);
    if (defined == model.Definitions().end())
    {
      break;
    }
    resolved = Trimmed(defined->second);
  }
  return resolved;
}

[[noreturn]] void Refuse(const std::string& name, const std::string& why)
{
  throw Unsupported("'" + name + "' cannot displace the mesh: " + why);
}

const char* NameOf(Mapping mapping)
{
  return mapping == Mapping::Covariant  ? "an H(curl) field"
    : mapping == Mapping::Contravariant ? "an H(div) field"
                                        : "a density";
}

/// Throws Unsupported where a field is no polynomial of xi on each element.
void RequirePolynomial(const Field& field, vtkUnstructuredGrid* grid, const std::string& text)
{
  if (field.mapping != Mapping::Identity)
  {
    Refuse(text,
      std::string("it is ") + NameOf(field.mapping) +
        ", whose values contain 1 / det J and are not polynomials; project it to a continuous "
        "vector space (H1) in the solver.");
  }
  auto* basis = vtkStringArray::SafeDownCast(
    grid->GetFieldData()->GetAbstractArray((kFieldPrefix + field.name + ".Basis").c_str()));
  if (basis != nullptr && basis->GetNumberOfValues() > 0 &&
    std::string(basis->GetValue(0)).starts_with("NURBS"))
  {
    Refuse(text,
      "it is a field of NURBS, which polynomials stand for up to an error that is not stored; "
      "project it to a continuous vector space (H1) in MFEM.");
  }
}

/// The sum of fields that a name or an expression is, each a polynomial of xi on each element.
std::vector<Summand> SummandsOf(
  const HighOrderModel& model, vtkUnstructuredGrid* grid, const std::string& text)
{
  const std::string resolved = Resolved(model, text);
  const Field& field = model.GetField(resolved);
  std::vector<Summand> sum =
    field.function == nullptr ? std::vector{ Summand{ &field } } : SumOfFields(model, resolved);
  if (sum.empty())
  {
    Refuse(text,
      "it is an expression other than a sum of fields with numbers as factors, and no "
      "polynomial of xi on each element; give a vector field, or vec(u,v,w) of scalar fields.");
  }
  for (const Summand& summand : sum)
  {
    RequirePolynomial(*summand.field, grid, text);
  }
  return sum;
}

/// Refuses grids with rational Bezier cells, whose fields are rational, too.
void RequirePolynomialCells(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkDataArray* weights = grid->GetPointData()->GetRationalWeights();
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; weights != nullptr && cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, points);
    for (vtkIdType k = 1; k < points->GetNumberOfIds(); ++k)
    {
      if (weights->GetComponent(points->GetId(k), 0) != weights->GetComponent(points->GetId(0), 0))
      {
        Refuse(name,
          "cell " + std::to_string(cell) +
            " is a rational Bezier cell, whose fields are rational functions; write the cells with "
            "equal weights.");
      }
    }
  }
}

std::string Components(const Field& field)
{
  return std::to_string(field.values.components) + " components";
}

Vec3 Axis(int c)
{
  Vec3 axis(0.0);
  axis[c] = 1.0;
  return axis;
}

std::vector<WarpTerm> TermsOfVec(
  const HighOrderModel& model, vtkUnstructuredGrid* grid, const std::vector<std::string>& arguments)
{
  std::vector<WarpTerm> terms;
  for (std::size_t c = 0; c < arguments.size(); ++c)
  {
    if (arguments[c] == "0")
    {
      continue;
    }
    for (const auto& [field, factor] : SummandsOf(model, grid, arguments[c]))
    {
      if (field->values.components != 1)
      {
        throw InvalidData("the displacement vec(...) takes scalar fields, and '" + arguments[c] +
          "' has " + Components(*field) + "; name scalars, or the vector field alone.");
      }
      terms.push_back({ field, 0, factor * Axis(static_cast<int>(c)) });
    }
  }
  return terms;
}

std::vector<WarpTerm> TermsOfScalar(const std::vector<Summand>& sum, const std::string& name,
  const std::optional<Vec3>& direction, bool isPlane)
{
  if (!direction)
  {
    throw InvalidData("'" + name + "' is a scalar, and a displacement is a vector; give " +
      (isPlane ? "a direction in the plane of the 2-D mesh (its z is 0), or vec(u,v)."
               : "the direction of its displacement, or vec(u,v,w)."));
  }
  if (!std::isfinite(direction->x + direction->y + direction->z) || *direction == Vec3(0.0))
  {
    throw InvalidData("the direction of the displacement is zero or not finite; give three finite "
                      "numbers that are not all 0.");
  }
  std::vector<WarpTerm> terms;
  std::ranges::transform(sum, std::back_inserter(terms),
    [&direction](const Summand& summand) {
      return WarpTerm{ summand.field, 0, summand.factor * *direction };
    });
  return terms;
}

std::vector<WarpTerm> TermsOfVector(
  const std::vector<Summand>& sum, const std::string& name, bool isPlane)
{
  const int components = sum.front().field->values.components;
  if (components != 3 && !(components == 2 && isPlane))
  {
    throw InvalidData("'" + name + "' has " + Components(*sum.front().field) +
      ", and a displacement of a " + (isPlane ? "2-D mesh has 2 or 3" : "3-D mesh has 3") +
      "; give a vector field, or vec(u,v,w) of scalar fields.");
  }
  std::vector<WarpTerm> terms;
  terms.reserve(sum.size() * static_cast<std::size_t>(components));
  for (const auto& [field, factor] : sum)
  {
    for (int c = 0; c < components; ++c)
    {
      terms.push_back({ field, c, factor * Axis(c) });
    }
  }
  return terms;
}

bool IsZero(const WarpTerm& term)
{
  const Expansion& values = term.field->values;
  for (int e = 0; e < values.Elements(); ++e)
  {
    const auto modes = static_cast<std::size_t>(values.SpaceOf(e).Modes());
    const double* first = values.Coefficients(e) + static_cast<std::size_t>(term.component) * modes;
    if (!std::all_of(first, first + modes, [](double c) { return c == 0.0; }))
    {
      return false;
    }
  }
  return true;
}

/// Leaves out terms along z that are zero, and refuses others.
void KeepInPlane(std::vector<WarpTerm>& terms, const std::string& name)
{
  std::erase_if(terms,
    [](const WarpTerm& term)
    { return term.direction.x == 0.0 && term.direction.y == 0.0 && IsZero(term); });
  if (std::ranges::any_of(terms, [](const WarpTerm& term) { return term.direction.z != 0.0; }))
  {
    Refuse(name,
      "the mesh is 2-D and stays in its plane, and this displacement leads out of it; give "
      "vec(u,v), or a direction whose z is 0.");
  }
}

/// A bound of the jumps that were found; throws Unsupported where the displacement is
/// discontinuous.
double JumpOf(const Mesh& mesh, const std::vector<WarpTerm>& terms)
{
  std::vector<Field> fields;
  for (const WarpTerm& term : terms)
  {
    if (std::ranges::find(fields, term.field->name, &Field::name) == fields.end())
    {
      fields.push_back(*term.field);
    }
  }
  const std::vector<Continuity> found = CompareAcrossElements(mesh, fields);
  double sum = 0.0;
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    if (found[f].comparisons > 0 && !found[f].IsContinuous())
    {
      std::ostringstream jump;
      jump << found[f].largestJump;
      Refuse(fields[f].name,
        "it jumps by up to " + jump.str() +
          " between elements, which would come apart; give a continuous field.");
    }
    for (const WarpTerm& term : terms)
    {
      sum += term.field->name == fields[f].name
        ? found[f].largestJump * std::hypot(term.direction.x, term.direction.y, term.direction.z)
        : 0.0;
    }
  }
  return sum;
}
} // namespace

Displacement DisplacementOf(
  const HighOrderModel& model, vtkUnstructuredGrid* grid, const WarpRequest& request)
{
  const std::optional<Slab> slab = SlabOf(grid);
  const bool isPlane = slab && !slab->inSpace;
  const std::vector<std::string> arguments = ArgumentsOfVec(Resolved(model, request.field));
  Displacement displacement;
  bool isScalar = false;
  if (!arguments.empty())
  {
    if (arguments.size() != 3 && !(arguments.size() == 2 && isPlane))
    {
      throw InvalidData("the displacement '" + request.field + "' has " +
        std::to_string(arguments.size()) + " components; give " +
        (isPlane ? "2: vec(u,v)." : "3: vec(u,v,w)."));
    }
    displacement.terms = TermsOfVec(model, grid, arguments);
  }
  else
  {
    const std::vector<Summand> sum = SummandsOf(model, grid, request.field);
    isScalar = sum.front().field->values.components == 1;
    displacement.terms = isScalar ? TermsOfScalar(sum, request.field, request.direction, isPlane)
                                  : TermsOfVector(sum, request.field, isPlane);
  }
  if (request.direction && !isScalar)
  {
    throw InvalidData("a direction is for scalar fields, and the displacement '" + request.field +
      "' is a vector; leave the direction out.");
  }
  RequirePolynomialCells(grid, request.field);
  if (isPlane)
  {
    KeepInPlane(displacement.terms, request.field);
  }
  displacement.jump = JumpOf(model.GetMesh(), displacement.terms);
  return displacement;
}
} // namespace pixelexact
