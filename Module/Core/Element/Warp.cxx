// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Warp.h"

#include "Core/Base/Error.h"
#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Basis/Recurrence.h"
#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Element/ElementUnits.h"
#include "Core/Math/Rounding.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <string>

namespace pixelexact
{
namespace
{
/// Roundings of a field's coefficient in the solver's or the converter's arithmetic.
constexpr int kFieldRoundings = 8;
/// Roundings of a coefficient of the deformed map: where long double has no more bits than double,
/// of the products, the sums and the scaling.
constexpr int kMapRoundings = 8;

/// The smallest space with the functions of both. Orders nest as the shapes need it where both do.
Space Join(const Space& a, const Space& b)
{
  Space joint = a;
  joint.form = std::max(a.form, b.form);
  for (std::size_t d = 0; d < 3; ++d)
  {
    joint.order[d] = std::max(a.order[d], b.order[d]);
  }
  return joint;
}

/// P_n^{(alpha,0)} at z, for n from 0 to `last`.
std::vector<long double> JacobiValues(int alpha, int last, long double z)
{
  const RecurrenceStep<long double>* step = RecurrenceTable<long double>::Row(alpha);
  std::vector<long double> values{ 1.0L };
  for (int n = 0; n < last; ++n)
  {
    const long double before = n > 0 ? values[static_cast<std::size_t>(n) - 1] : 0.0L;
    values.push_back((step[n].a * z + step[n].b) * values.back() - step[n].c * before);
  }
  return values;
}

/// The modes of a pyramid's Collapsed form at xi, below the apex.
void CollapsedPyramidModes(const Space& space, const LongVec3& xi, long double* values)
{
  const long double h = (1.0L - xi[2]) / 2.0L;
  const auto along = [h](long double x) { return (1.0L + x - h) / h; };
  const std::vector<long double> x = JacobiValues(0, space.order[0], along(xi[0]));
  const std::vector<long double> y = JacobiValues(0, space.order[1], along(xi[1]));
  std::map<int, std::vector<long double>> z;
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      const int m = std::max(p, q);
      std::vector<long double>& family = z[m];
      if (family.empty())
      {
        family = JacobiValues(2 * m + 2, space.order[2] - m, xi[2]);
      }
      values[mode] = x[static_cast<std::size_t>(p)] * y[static_cast<std::size_t>(q)] *
        std::pow(h, static_cast<long double>(m)) * family[static_cast<std::size_t>(r)];
    });
}

/// From a pyramid's Collapsed form to the Tensor form of these orders.
const ChangeOfBasis& ToTensorForm(const Space& from, const Space& to)
{
  static std::mutex mutex;
  static std::map<std::pair<Space, Space>, ChangeOfBasis> known;
  const std::scoped_lock lock(mutex);
  const auto found = known.find({ from, to });
  return found != known.end() ? found->second
                              : known
                                  .emplace(std::pair(from, to),
                                    ChangeOfBasis::FromFunctions(to, from.Modes(),
                                      [&from](const LongVec3& xi, long double* values)
                                      { CollapsedPyramidModes(from, xi, values); }))
                                  .first->second;
}

/// Calls visit(mode, number) for each mode of `part` with its number in `whole`, which contains
/// the space and has its form.
template <class Visit>
void ForEachNumber(const Space& part, const Space& whole, Visit&& visit)
{
  std::map<std::array<int, 2>, int> rows; // of whole, by p and q: the number of r = 0
  ForEachMode(whole,
    [&](int p, int q, int r, int mode)
    {
      if (r == 0)
      {
        rows[{ p, q }] = mode;
      }
    });
  ForEachMode(part, [&](int p, int q, int r, int mode) { visit(mode, rows.at({ p, q }) + r); });
}

/// The modes of one component in the space `whole`.
std::vector<double> Embedded(const Space& space, const double* modes, const Space& whole)
{
  std::vector<double> embedded(static_cast<std::size_t>(whole.Modes()), 0.0);
  if (space.form != whole.form)
  {
    ToTensorForm(space, whole)
      .Apply({ modes, static_cast<std::size_t>(space.Modes()) }, 0.0, embedded);
    return embedded;
  }
  ForEachNumber(space, whole,
    [&](int mode, int number) { embedded[static_cast<std::size_t>(number)] = modes[mode]; });
  return embedded;
}

void RequireFinite(std::span<const double> modes, const Field& field, int element)
{
  if (!std::ranges::all_of(modes, [](double c) { return std::isfinite(c); }))
  {
    throw InvalidData("the displacement '" + field.name + "' is not finite in element " +
      std::to_string(element) + "; choose another field, or leave out the element.");
  }
}

/// A sum in long double of each mode of three components.
class DisplacementSum
{
public:
  DisplacementSum(const Mesh& mesh, int element, std::span<const WarpTerm> displacement)
    : space_(mesh.map.SpaceOf(element))
  {
    for (const WarpTerm& term : displacement)
    {
      space_ = Join(space_, term.field->values.SpaceOf(element));
    }
    const auto count = static_cast<std::size_t>(space_.Modes());
    Sum.assign(3 * count, 0.0L);
    Magnitude.assign(3 * count, 0.0L);
    for (const WarpTerm& term : displacement)
    {
      const Space& space = term.field->values.SpaceOf(element);
      const auto width = static_cast<std::size_t>(space.Modes());
      const double* modes =
        term.field->values.Coefficients(element) + static_cast<std::size_t>(term.component) * width;
      RequireFinite({ modes, width }, *term.field, element);
      const std::vector<double> embedded = Embedded(space, modes, space_);
      for (std::size_t c = 0; c < 3; ++c)
      {
        const long double factor = term.direction[static_cast<int>(c)];
        for (std::size_t k = 0; k < count && factor != 0.0L; ++k)
        {
          Sum[c * count + k] += factor * embedded[k];
          Magnitude[c * count + k] += std::fabs(factor * embedded[k]);
        }
      }
    }
  }

  [[nodiscard]] const Space& GetSpace() const { return space_; }
  [[nodiscard]] std::span<const long double> Modes() const { return Sum; }
  /// The sums of the terms' magnitudes.
  [[nodiscard]] std::span<const long double> Magnitudes() const { return Magnitude; }

private:
  Space space_;
  std::vector<long double> Sum;
  std::vector<long double> Magnitude;
};

/// The map's modes in the space `whole`, component by component.
std::vector<double> EmbeddedMap(const Mesh& mesh, int element, const Space& whole)
{
  const Space& space = mesh.map.SpaceOf(element);
  std::vector<double> modes;
  for (int c = 0; c < 3; ++c)
  {
    const std::vector<double> one =
      Embedded(space, mesh.map.Coefficients(element) + c * space.Modes(), whole);
    modes.insert(modes.end(), one.begin(), one.end());
  }
  return modes;
}

/// The Euclidean norm over the components of the sums of |mode| times a bound of the mode.
double BoundOf(const Space& space, std::span<const long double> modes)
{
  const auto count = static_cast<std::size_t>(space.Modes());
  std::array<double, 3> sums{};
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      const double most = ModeBound(space, p, q, r);
      for (std::size_t c = 0; c < 3; ++c)
      {
        sums[c] +=
          most * static_cast<double>(std::fabs(modes[c * count + static_cast<std::size_t>(mode)]));
      }
    });
  return std::hypot(sums[0], sums[1], sums[2]);
}

/// A box that contains the values of three components.
Box3 HullOfModes(const Space& space, std::span<const long double> modes)
{
  const BernsteinForm& form = BernsteinForm::Of(space);
  const auto count = static_cast<std::size_t>(space.Modes());
  std::vector<double> rounded(count);
  std::vector<double> bernstein(static_cast<std::size_t>(form.Size()));
  Box3 box;
  for (std::size_t c = 0; c < 3; ++c)
  {
    std::ranges::transform(modes.subspan(c * count, count), rounded.begin(),
      [](long double mode) { return static_cast<double>(mode); });
    form.Convert(rounded.data(), bernstein);
    const Hull hull = HullOf(bernstein);
    box.lower[static_cast<int>(c)] = hull.lower;
    box.upper[static_cast<int>(c)] = hull.upper;
  }
  return box;
}

/// Whether an element in this box of its units can keep them.
bool FitsUnits(const Box3& box)
{
  double reach = 0.0;
  double half = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    reach = std::max({ reach, std::fabs(box.lower[d]), std::fabs(box.upper[d]) });
    half = std::max(half, 0.5 * (box.upper[d] - box.lower[d]));
  }
  return reach <= 2.0 && half >= 0.25;
}

/// The deformed map of one element, in units of its own.
struct WarpedElement
{
  Space space;
  std::vector<long double> modes;
  Vec3 centre;
  double size;
  double uncertainty;
};

/// Changes the units of an element where it has outgrown them. `magnitudes`: per mode, in world
/// units, of the terms that it is the sum of.
void FitUnits(WarpedElement& warped, std::vector<long double>& magnitudes)
{
  const Box3 box = HullOfModes(warped.space, warped.modes);
  if (FitsUnits(box))
  {
    return;
  }
  const ElementUnits units = MakeElementUnits(
    warped.centre + warped.size * box.lower, warped.centre + warped.size * box.upper);
  const double size = std::ldexp(1.0, units.exponent);
  const std::size_t count = warped.modes.size() / 3;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const int d = static_cast<int>(c);
    const long double shift =
      static_cast<long double>(warped.centre[d]) - static_cast<long double>(units.centre[d]);
    // The first mode is the constant 1.
    warped.modes[c * count] += shift / warped.size;
    magnitudes[c * count] += std::fabs(shift);
  }
  for (long double& mode : warped.modes)
  {
    mode *= warped.size / size;
  }
  warped.centre = units.centre;
  warped.size = size;
}

Vec3 CentreOf(const Mesh& mesh, std::size_t element)
{
  return { mesh.centre[3 * element], mesh.centre[3 * element + 1], mesh.centre[3 * element + 2] };
}

WarpedElement WarpElement(
  const Mesh& mesh, int element, std::span<const WarpTerm> displacement, double scale, double jump)
{
  const auto e = static_cast<std::size_t>(element);
  const DisplacementSum sum(mesh, element, displacement);
  const std::vector<double> map = EmbeddedMap(mesh, element, sum.GetSpace());
  WarpedElement warped{ sum.GetSpace(), {}, CentreOf(mesh, e), mesh.size[e], 0.0 };
  std::vector<long double> magnitudes;
  for (std::size_t k = 0; k < map.size(); ++k)
  {
    warped.modes.push_back(map[k] + scale * (sum.Modes()[k] / warped.size));
    magnitudes.push_back(std::fabs(map[k] * warped.size) + std::fabs(scale * sum.Modes()[k]));
  }
  FitUnits(warped, magnitudes);
  warped.uncertainty = mesh.uncertainty[e] + std::fabs(scale) * jump +
    Gamma(kMapRoundings) * BoundOf(warped.space, magnitudes) +
    std::fabs(scale) * Gamma(kFieldRoundings) * BoundOf(warped.space, sum.Magnitudes());
  if (!std::isfinite(warped.uncertainty))
  {
    throw InvalidData("is too large for double arithmetic; give a smaller scale.");
  }
  return warped;
}

WarpedElement MoveElement(
  const Mesh& mesh, int element, const AffineMotion& motion, double stretch, double error)
{
  const auto e = static_cast<std::size_t>(element);
  const Space& space = mesh.map.SpaceOf(element);
  const auto count = static_cast<std::size_t>(space.Modes());
  const double* map = mesh.map.Coefficients(element);
  WarpedElement moved{ space, {}, {}, mesh.size[e], 0.0 };
  std::vector<long double> magnitudes;
  const std::array<long double, 3> centre = motion.Apply(CentreOf(mesh, e));
  double largest = 0.0; // of the coordinates from which the centre is computed
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      long double sum = 0.0L;
      long double magnitude = 0.0L;
      for (std::size_t j = 0; j < 3; ++j)
      {
        const long double term = motion.matrix[c][j] * map[j * count + k];
        sum += term;
        magnitude += std::fabs(term);
      }
      moved.modes.push_back(sum);
      magnitudes.push_back(magnitude * moved.size);
    }
    const int d = static_cast<int>(c);
    moved.centre[d] = static_cast<double>(centre[c]);
    // The first mode is the constant 1.
    const long double rest = centre[c] - static_cast<long double>(moved.centre[d]);
    moved.modes[c * count] += rest / moved.size;
    magnitudes[c * count] += std::fabs(rest);
    largest = std::max(largest, static_cast<double>(std::fabs(motion.to[c])));
  }
  FitUnits(moved, magnitudes);
  const Vec3 from(motion.from[0], motion.from[1], motion.from[2]);
  const Vec3 arm = CentreOf(mesh, e) - from;
  largest += stretch * std::hypot(arm.x, arm.y, arm.z);
  moved.uncertainty = stretch * mesh.uncertainty[e] + error +
    Gamma(kMapRoundings) * BoundOf(space, magnitudes) +
    kMapRoundings * static_cast<double>(std::numeric_limits<long double>::epsilon()) * largest;
  if (!std::isfinite(moved.uncertainty))
  {
    throw InvalidData("is too large for double arithmetic; move the mesh nearer to the origin.");
  }
  return moved;
}

/// The mesh of the elements that make(e) returns, in these spaces.
template <class Make>
OwnedMesh MakeMesh(std::span<const Space> spaces, Make&& make)
{
  const std::size_t elements = spaces.size();
  OwnedMesh mesh;
  mesh.map.Allocate(spaces, 3);
  mesh.centre.resize(3 * elements);
  mesh.size.resize(elements);
  mesh.uncertainty.resize(elements);
  tbb::parallel_for(std::size_t{ 0 }, elements,
    [&](std::size_t e)
    {
      WarpedElement element;
      try
      {
        element = make(static_cast<int>(e));
      }
      catch (const InvalidData& error)
      {
        const std::string problem = error.what();
        throw InvalidData(problem.starts_with("is too large")
            ? "element " + std::to_string(e) + " of the deformed mesh " + problem
            : problem);
      }
      std::ranges::transform(element.modes, mesh.map.Coefficients(e).begin(),
        [](long double mode) { return static_cast<double>(mode); });
      for (std::size_t c = 0; c < 3; ++c)
      {
        mesh.centre[3 * e + c] = element.centre[static_cast<int>(c)];
      }
      mesh.size[e] = element.size;
      mesh.uncertainty[e] = element.uncertainty;
    });
  return mesh;
}
} // namespace

JointModes JoinModes(const Mesh& mesh, int element, std::span<const WarpTerm> displacement)
{
  const DisplacementSum sum(mesh, element, displacement);
  JointModes joint{ sum.GetSpace(), EmbeddedMap(mesh, element, sum.GetSpace()), {} };
  for (const long double mode : sum.Modes())
  {
    joint.displacement.push_back(static_cast<double>(mode));
  }
  return joint;
}

OwnedMesh WarpedMesh(
  const Mesh& mesh, std::span<const WarpTerm> displacement, double scale, double jump)
{
  std::vector<Space> spaces;
  spaces.reserve(static_cast<std::size_t>(mesh.Elements()));
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    Space space = mesh.map.SpaceOf(e);
    for (const WarpTerm& term : displacement)
    {
      space = Join(space, term.field->values.SpaceOf(e));
    }
    spaces.push_back(space);
  }
  return MakeMesh(spaces, [&](int e) { return WarpElement(mesh, e, displacement, scale, jump); });
}

OwnedMesh MovedMesh(const Mesh& mesh, const AffineMotion& motion, std::span<const double> errors)
{
  std::vector<Space> spaces;
  spaces.reserve(static_cast<std::size_t>(mesh.Elements()));
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    spaces.push_back(mesh.map.SpaceOf(e));
  }
  const double stretch = motion.Stretch();
  return MakeMesh(spaces,
    [&](int e)
    { return MoveElement(mesh, e, motion, stretch, errors[static_cast<std::size_t>(e)]); });
}
} // namespace pixelexact
