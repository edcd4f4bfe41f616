// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/SamplingSink.h"

#include "Core/Base/Error.h"
#include "Core/Base/StageClock.h"
#include "Core/Element/Enclosure.h"
#include "Core/Element/FieldFunction.h"
#include "Core/Element/FieldMapping.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
/// to[index[k]] = valueOf(k), for indices that ascend: most follow one another, and are written
/// together.
template <class T, class ValueOf>
void Put(std::span<const int> index, std::span<T> to, const ValueOf& valueOf)
{
  constexpr std::size_t kRun = 8;
  for (std::size_t k = 0; k < index.size();)
  {
    T* first = &to[static_cast<std::size_t>(index[k])];
    if (k + kRun <= index.size() && index[k + kRun - 1] - index[k] == static_cast<int>(kRun) - 1)
    {
      std::array<T, kRun> run;
      for (std::size_t i = 0; i < kRun; ++i)
      {
        run[i] = valueOf(k + i);
      }
      std::ranges::copy(run, first);
      k += kRun;
    }
    else
    {
      *first = valueOf(k);
      ++k;
    }
  }
}

void Scatter(
  std::span<const int> index, double* const* from, std::size_t width, std::span<double> to)
{
  if (width == 1)
  {
    Put(index, to, [values = from[0]](std::size_t k) { return values[k]; });
    return;
  }
  for (std::size_t c = 0; c < width; ++c)
  {
    for (std::size_t k = 0; k < index.size(); ++k)
    {
      to[static_cast<std::size_t>(index[k]) * width + c] = from[c][k];
    }
  }
}
/// Collects vectors of a batch's points, in the order of `index`, padded with the last.
template <class ValueOf>
const double* const* Gather(
  std::span<const int> index, std::size_t stride, OutputArrays& to, const ValueOf& valueOf)
{
  double* const* arrays = to.Get(3, stride);
  for (std::size_t k = 0; k < stride; ++k)
  {
    const int at = index[std::min(k, index.size() - 1)];
    for (int d = 0; d < 3; ++d)
    {
      arrays[d][k] = valueOf(at, d);
    }
  }
  return arrays;
}
} // namespace

double* const* OutputArrays::Get(std::size_t arrays, std::size_t stride)
{
  if (Storage.size() < arrays * stride)
  {
    Storage.resize(arrays * stride);
  }
  Pointers.resize(arrays);
  for (std::size_t k = 0; k < arrays; ++k)
  {
    Pointers[k] = &Storage[k * stride];
  }
  return Pointers.data();
}

SamplingSink::SamplingSink(
  const Mesh& mesh, const Field* field, const LanePoints& points, const SampleTarget& target)
  : mesh_(mesh)
  , field_(field)
  , Points(points)
  , Target(target)
{
}

void SamplingSink::Inside(
  int element, std::span<const int> index, const double* const xi[3], const double* residual)
{
  const StageScope scope(Stage::Evaluation);
  const auto write = [&](auto target, const auto& valueOf)
  {
    if (!target.empty())
    {
      Put(index, target, valueOf);
    }
  };
  write(Target.element, [&](std::size_t) { return element; });
  write(Target.xi, [&](std::size_t k) { return Vec3(xi[0][k], xi[1][k], xi[2][k]); });
  write(Target.verdict, [&](std::size_t) { return Verdict::Inside; });
  write(Target.residual, [&](std::size_t k) { return residual[k]; });
  if (field_)
  {
    const LanePoints at{ { xi[0], xi[1], xi[2] }, static_cast<int>(index.size()) };
    if (!Target.value.empty() || !Target.gradient.empty())
    {
      EvaluateField(element, index, at);
    }
    if (!Target.valueLower.empty())
    {
      EncloseField(element, index, at);
    }
  }
}

void SamplingSink::Unknown(int index, int element)
{
  const auto i = static_cast<std::size_t>(index);
  if (!Target.element.empty())
  {
    Target.element[i] = element;
  }
  if (!Target.verdict.empty())
  {
    Target.verdict[i] = Verdict::Unknown;
  }
}

void SamplingSink::EvaluateField(int element, std::span<const int> index, const LanePoints& xi)
{
  const auto components = static_cast<std::size_t>(field_->values.components);
  const auto stride = static_cast<std::size_t>(PaddedCount(xi.count));
  const bool gradient = !Target.gradient.empty();
  double* const* out = Arrays.Get(components * (gradient ? 4 : 1), stride);
  double* const* slopes = gradient ? out + components : nullptr;
  if (field_->function != nullptr)
  {
    FunctionPoints points{ xi };
    if (Points.count > 0)
    {
      points.x = Gather(index, stride, Places, [this](int at, int d) { return Points.x[d][at]; });
    }
    if (!Target.normals.empty() && field_->function->NeedsNormals())
    {
      points.normal = Gather(index, stride, Normals,
        [this](int at, int d) { return Target.normals[static_cast<std::size_t>(at)][d]; });
    }
    field_->function->Evaluate(mesh_, element, points, out, slopes);
  }
  else
  {
    EvaluatePolynomials(element, xi, out, slopes);
  }
  if (gradient)
  {
    Scatter(index, out + components, 3 * components, Target.gradient);
  }
  if (!Target.value.empty())
  {
    Scatter(index, out, components, Target.value);
  }
}

void SamplingSink::EvaluatePolynomials(
  int element, const LanePoints& xi, double* const* out, double* const* slopes)
{
  const Expansion& values = field_->values;
  const Space& space = values.SpaceOf(element);
  const KernelSet kernels = KernelsFor(space);
  const bool inFloats = slopes == nullptr && Target.precision == Precision::Float;
  if (slopes != nullptr)
  {
    kernels.gradient(space, values.Coefficients(element), values.components, xi, out, slopes);
  }
  else if (inFloats)
  {
    kernels.valueInFloats(space, values.Coefficients(element), values.components, xi, out);
  }
  else
  {
    kernels.value(space, values.Coefficients(element), values.components, xi, out);
  }
  ApplyMapping(mesh_, element, field_->mapping, xi, values.components, out, slopes);
  if (Target.check != nullptr && inFloats)
  {
    CheckFloats(element, xi, out);
  }
}

/// Evaluates the first points once more.
void SamplingSink::CheckFloats(int element, const LanePoints& xi, const double* const* values)
{
  const Expansion& field = field_->values;
  const Space& space = field.SpaceOf(element);
  const LanePoints some{ { xi.x[0], xi.x[1], xi.x[2] }, std::min(xi.count, kLanePadding) };
  double* const* exact = Checked.Get(static_cast<std::size_t>(field.components), kLanePadding);
  KernelsFor(space).value(space, field.Coefficients(element), field.components, some, exact);
  ApplyMapping(mesh_, element, field_->mapping, some, field.components, exact, nullptr);
  PrecisionCheck check;
  check.points = some.count;
  for (int c = 0; c < field.components; ++c)
  {
    for (int k = 0; k < some.count; ++k)
    {
      const double difference = std::fabs(values[c][k] - exact[c][k]);
      if (difference > check.largest && std::isfinite(difference))
      {
        check.largest = difference;
      }
    }
  }
  Target.check->Add(check);
}

void SamplingSink::EncloseField(int element, std::span<const int> index, const LanePoints& xi)
{
  const auto components = static_cast<std::size_t>(field_->values.components);
  const auto stride = static_cast<std::size_t>(PaddedCount(xi.count));
  double* const* arrays = Arrays.Get(3 + 2 * components, stride);
  for (std::size_t k = 0; k < stride; ++k)
  {
    const int at = index[std::min(k, index.size() - 1)];
    for (int d = 0; d < 3; ++d)
    {
      arrays[d][k] = Points.x[d][at];
    }
  }
  double* const* lower = arrays + 3;
  double* const* upper = lower + components;
  EncloseValues(mesh_, *field_, element, xi, { { arrays[0], arrays[1], arrays[2] }, xi.count },
    { lower, upper });
  Scatter(index, lower, components, Target.valueLower);
  Scatter(index, upper, components, Target.valueUpper);
}

void RequireSizes(const Field* field, std::size_t points, const SampleTarget& target)
{
  const std::size_t components = field ? static_cast<std::size_t>(field->values.components) : 0;
  const auto fits = [](std::size_t size, std::size_t wanted)
  { return size == 0 || size == wanted; };
  if (!fits(target.element.size(), points) || !fits(target.xi.size(), points) ||
    !fits(target.verdict.size(), points) || !fits(target.residual.size(), points) ||
    !fits(target.value.size(), points * components) ||
    !fits(target.gradient.size(), 3 * points * components) ||
    !fits(target.valueLower.size(), points * components) ||
    target.valueUpper.size() != target.valueLower.size())
  {
    throw Error("sample arrays must be empty or hold one entry for each of the " +
      std::to_string(points) + " points.");
  }
}
} // namespace pixelexact
