// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/LocationStudy.h"

#include "Stability/LocationCheck.h"

#include "Core/Basis/ModeBound.h"
#include "Core/Bounds/ElementBounds.h"
#include "Core/Element/Kernels.h"
#include "Core/Location/Sample.h"
#include "Core/Math/Rounding.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>

namespace pixelexact::testing
{
namespace
{
constexpr int kFieldOrder = 4;

/// A field of moderate order on every element of a mesh of one shape.
ExpansionBuilder MakeField(Shape shape, int elements)
{
  const Space space = UniformSpace(shape, kFieldOrder);
  ExpansionBuilder field(1);
  field.Spaces.push_back(space);
  Random random(71);
  for (int e = 0; e < elements; ++e)
  {
    field.SpaceOf.push_back(0);
    field.Offset.push_back(static_cast<std::int64_t>(field.Coefficients.size()));
    ForEachMode(space,
      [&](int p, int q, int r, int) {
        field.Coefficients.push_back(
          random() * std::pow(0.7, p + q + r) / ModeBound(space, p, q, r));
      });
  }
  return field;
}

class Study
{
public:
  explicit Study(const LocationCase& subject)
    : Subject(subject)
    , Elements(subject.mesh.View())
    , FieldModes(MakeField(subject.shape, Elements.Elements()))
    , field_{ "u", FieldModes.View() }
    , Finder(Elements)
    , Check(Elements, subject.element, Finder.Index().ElementBox(subject.element), field_)
  {
    Validate(Elements);
    Validate(field_, Elements);
    result.sweep = subject.sweep;
    result.shape = Name(subject.shape);
    result.order = subject.order;
    result.parameter = subject.parameter;
    result.at = subject.at;
  }

  void Inside(int count, std::vector<ScatterPoint>* scatter)
  {
    const auto points = MakePoints(Subject.inside, count, 72);
    CountSteps(points.x);
    const auto found = Locate(points.x);
    std::vector<PointErrors> measured(points.x.size());
    tbb::parallel_for(std::size_t{ 0 }, points.x.size(),
      [&](std::size_t i) { measured[i] = Check.Measure(points.xi[i], points.x[i], found[i]); });
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      Add(found[i], measured[i]);
      if (scatter && measured[i].firstOrder && found[i].verdict == Verdict::Inside)
      {
        scatter->push_back({ result.sweep, result.shape, result.at, measured[i].condition,
          measured[i].xiError / kUnitRoundoff, measured[i].xiBound / kUnitRoundoff });
      }
    }
  }

  void Outside(int count)
  {
    const auto points = MakePoints(Subject.outside, count, 73);
    const auto found = Locate(points.x);
    std::vector<char> known(points.x.size());
    tbb::parallel_for(std::size_t{ 0 }, points.x.size(),
      [&](std::size_t i) { known[i] = Check.IsKnownOutside(points.xi[i], points.x[i]) ? 1 : 0; });
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      if (known[i] != 0)
      {
        ++(found[i].verdict == Verdict::Outside   ? result.outside.right
            : found[i].verdict == Verdict::Inside ? result.outside.wrong
                                                  : result.outside.unknown);
      }
    }
  }

  Row Finish()
  {
    result.careful = Finder.Counters().careful;
    result.boxes = Finder.Counters().mostBoxes;
    return result;
  }

private:
  struct Points
  {
    std::vector<Vec3> xi;
    std::vector<Vec3> x;
  };

  Points MakePoints(const std::function<Vec3(Random&)>& next, int count, std::uint64_t seed) const
  {
    Points points;
    Random random(seed);
    for (int i = 0; i < count; ++i)
    {
      points.xi.push_back(next(random));
    }
    points.x.resize(points.xi.size());
    tbb::parallel_for(std::size_t{ 0 }, points.xi.size(),
      [&](std::size_t i)
      { points.x[i] = MapToWorld(Elements, Subject.element, ToQuad(points.xi[i])); });
    return points;
  }

  std::vector<FoundPoint> Locate(const std::vector<Vec3>& x) const
  {
    std::vector<std::int32_t> element(x.size());
    std::vector<Vec3> xi(x.size());
    std::vector<Verdict> verdict(x.size());
    std::vector<double> residual(x.size());
    std::vector<double> value(x.size());
    SampleTarget target;
    target.element = element;
    target.xi = xi;
    target.verdict = verdict;
    target.residual = residual;
    target.value = value;
    Sample(Finder, &field_, x, target);
    std::vector<FoundPoint> found;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      found.push_back({ verdict[i], element[i], xi[i], residual[i], value[i] });
    }
    return found;
  }

  /// Counts the steps of the fast path, from the element's frame; the maximum where it does not
  /// converge.
  void CountSteps(const std::vector<Vec3>& x)
  {
    const ElementBounds bounds = MakeElementBounds(Elements, Subject.element);
    const InverseProblem problem = MakeInverseProblem(Elements, Subject.element, bounds);
    for (const Vec3& point : x)
    {
      double lanes[10][kLanePadding];
      for (int d = 0; d < 3; ++d)
      {
        std::fill_n(lanes[d], kLanePadding, point[d]);
      }
      KernelsFor(problem.space)
        .invert(problem, { { lanes[0], lanes[1], lanes[2] }, 1 },
          { { lanes[3], lanes[4], lanes[5] }, lanes[6], lanes[7], lanes[8], lanes[9] });
      result.steps = std::max(result.steps, static_cast<int>(lanes[9][0]));
    }
  }

  void Add(const FoundPoint& found, const PointErrors& measured)
  {
    Raise(result.condition, measured.condition);
    if (found.verdict == Verdict::Unknown)
    {
      ++result.inside.unknown;
      return;
    }
    if (found.verdict == Verdict::Outside || found.element != Subject.element)
    {
      ++result.inside.wrong;
      return;
    }
    ++result.inside.right;
    Raise(result.backwardOverBound, measured.backwardOverBound);
    result.value.Add(measured.valueError, measured.value, measured.magnitude, measured.valueBound);
    Raise(result.xiError, measured.xiError / kUnitRoundoff);
    if (measured.firstOrder)
    {
      Raise(result.xiOverBound, measured.xiError / measured.xiBound);
    }
  }

  const LocationCase& Subject;
  Mesh Elements;
  ExpansionBuilder FieldModes;
  Field field_;
  Locator Finder;
  LocationCheck Check;
  Row result;
};
} // namespace

Row StudyLocation(const LocationCase& subject, int insidePoints, int outsidePoints,
  std::vector<ScatterPoint>* scatter)
{
  const auto start = std::chrono::steady_clock::now();
  Study study(subject);
  study.Inside(insidePoints, scatter);
  study.Outside(outsidePoints);
  Row row = study.Finish();
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return row;
}
} // namespace pixelexact::testing
