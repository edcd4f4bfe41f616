// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/CertifiedFacts.h"

#include "Core/Math/Rounding.h"
#include "Scene/Model.h"

#include "Core/Base/Counted.h"
#include "Core/Expression/Expression.h"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr std::size_t kMaxListed = 10;

/// Passes progress on as a part of the whole work.
class Steps
{
public:
  Steps(ProgressLine& line, std::size_t count)
    : Line(line)
    , Count(static_cast<double>(count))
  {
  }
  RangeProgress Next()
  {
    const double from = Done / Count;
    Done += 1.0;
    return [this, from](double part) { Line(from + part / Count); };
  }

private:
  ProgressLine& Line;
  double Count;
  double Done = 0.0;
};

std::size_t StepsOf(const Field& field)
{
  return static_cast<std::size_t>(field.values.components) + 1;
}

CertifiedField CertifyField(const Mesh& mesh, const Field& field, Steps& steps)
{
  CertifiedField facts;
  facts.name = field.name;
  facts.isExpression = field.function != nullptr;
  RequireSurfaceRange(mesh, field);
  const auto ask = [&](Quantity quantity, int component) {
    return RangeOf(mesh, { quantity, &field, component }, RangeEffort{}, steps.Next());
  };
  for (int c = 0; c < field.values.components; ++c)
  {
    facts.components.push_back(ask(Quantity::Component, c));
  }
  if (field.values.components > 1)
  {
    facts.magnitude = ask(Quantity::Magnitude, 0);
    return facts;
  }
  if (facts.isExpression || mesh.isShell)
  {
    return facts; // the gradient is another expression, and not available on a surface in space
  }
  facts.gradientIsAnswerable = IsAnswerable({ Quantity::GradientMagnitude, &field });
  if (facts.gradientIsAnswerable)
  {
    facts.gradient = ask(Quantity::GradientMagnitude, 0);
  }
  return facts;
}

/// Largest distance of the outer ends from the attained range, relative to that range.
double RelativeExcess(const CertifiedRange& range)
{
  const double width = range.attained.upper - range.attained.lower;
  return std::max(range.GapBelow() + range.GapAbove(), 0.0) / std::max(width, 0.0);
}

/// `outward`: of a range that holds something, else of one that is held.
std::string RangeText(const Interval& range, bool outward)
{
  // Ten digits, unless the range is narrower than they show.
  const int digits = range.Width() > 1e-7 * range.Magnitude() ? 10 : 17;
  return fmt::format(
    "[{}, {}]", Rounded(range.lower, !outward, digits), Rounded(range.upper, outward, digits));
}

std::string RangeText(const MeshRange& range)
{
  std::string text;
  if (range.range.outer.IsEmpty())
  {
    text = "nothing finite";
  }
  else if (!range.range.outer.IsFinite())
  {
    text = "no bound found in " + Counted(range.unbounded, "element");
  }
  else
  {
    text = "in " + RangeText(range.range.outer, true);
    if (!range.range.attained.IsEmpty())
    {
      text += ", attains " + RangeText(range.range.attained, false);
    }
    text += range.range.met ? "" : " (budget spent)";
  }
  if (range.notFinite > 0)
  {
    text += "; not finite in " + Counted(range.notFinite, "element") + ", left out";
  }
  return text;
}

nlohmann::ordered_json RangeJson(const MeshRange& range)
{
  // Numbers that are not known become null.
  const bool attains = !range.range.attained.IsEmpty();
  const bool holds = !range.range.outer.IsEmpty();
  return { { "lower", holds ? range.range.outer.lower : kInfinity },
    { "upper", holds ? range.range.outer.upper : kInfinity },
    { "attained_lower", attains ? range.range.attained.lower : kInfinity },
    { "attained_upper", attains ? range.range.attained.upper : kInfinity },
    { "relative_excess", RelativeExcess(range.range) }, { "tolerance_met", range.range.met },
    { "boxes", range.boxes }, { "not_finite_elements", range.notFinite },
    { "unbounded_elements", range.unbounded } };
}

std::string List(const std::vector<std::int64_t>& cells, std::int64_t count)
{
  const bool more = static_cast<std::int64_t>(cells.size()) < count;
  return cells.empty() ? "" : fmt::format(" ({}{})", fmt::join(cells, ", "), more ? ", ..." : "");
}
} // namespace

CertifiedFacts Certify(const LoadedModel& input, const std::vector<std::string>& names)
{
  const auto begin = std::chrono::steady_clock::now();
  std::vector<const Field*> fields;
  for (const std::string& name : names)
  {
    fields.push_back(&input.model->GetField(name));
    RequireAnswer({ Quantity::Component, fields.back() });
  }
  for (const Field& field : input.model->Fields())
  {
    if (names.empty())
    {
      fields.push_back(&field);
    }
  }
  const Mesh& mesh = input.model->GetMesh();
  ProgressLine line("certifying");
  std::size_t count = 2;
  for (const Field* field : fields)
  {
    count += StepsOf(*field);
  }
  Steps steps(line, count);
  CertifiedFacts facts;
  const auto verdicts = ValidityOf(mesh, RangeEffort{}, steps.Next());
  double lower = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < verdicts.size(); ++e)
  {
    const auto validity = static_cast<std::size_t>(verdicts[e].validity);
    ++facts.count[validity];
    lower = std::min(lower, verdicts[e].jacobian.outer.lower);
    if (verdicts[e].validity != Validity::Valid && facts.first[validity].size() < kMaxListed)
    {
      facts.first[validity].push_back(input.model->SourceCells()[e]);
    }
  }
  facts.jacobian = RangeOf(mesh, { Quantity::Jacobian }, RangeEffort{}, steps.Next());
  // Both bounds hold; where all elements are valid this one is positive.
  facts.jacobian.range.outer.lower = std::max(facts.jacobian.range.outer.lower, lower);
  for (const Field* field : fields)
  {
    facts.fields.push_back(CertifyField(mesh, *field, steps));
  }
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return facts;
}

void AddTo(Table& table, const CertifiedFacts& facts)
{
  std::string name = "certified";
  const auto row = [&]<class... Values>(fmt::format_string<Values...> text, Values&&... values)
  {
    table.Row(name, text, std::forward<Values>(values)...);
    name.clear();
  };
  for (const CertifiedField& field : facts.fields)
  {
    for (std::size_t c = 0; c < field.components.size(); ++c)
    {
      row("{}{} {}", field.name,
        field.components.size() > 1 ? fmt::format(" (component {})", c) : std::string(),
        RangeText(field.components[c]));
    }
    if (field.magnitude)
    {
      row("|{}| {}", field.name, RangeText(*field.magnitude));
    }
    if (field.gradient)
    {
      row("|grad {}| {}", field.name, RangeText(*field.gradient));
    }
    if (!field.gradientIsAnswerable)
    {
      row("|grad {}| not certified: a density's gradient", field.name);
    }
  }
  row("det J {}, world volume per volume of the reference shape", RangeText(facts.jacobian));
  std::vector<std::string> verdicts;
  for (const Validity validity : { Validity::Valid, Validity::Inverted, Validity::Undecided })
  {
    const auto i = static_cast<std::size_t>(validity);
    verdicts.push_back(
      fmt::format("{} {}{}", facts.count[i], Name(validity), List(facts.first[i], facts.count[i])));
  }
  row("elements: {}", Listed(verdicts));
  row("proven in {} s", Short(facts.seconds));
}

void AddTo(nlohmann::ordered_json& summary, const CertifiedFacts& facts)
{
  nlohmann::ordered_json jacobian;
  for (const Validity validity : { Validity::Valid, Validity::Inverted, Validity::Undecided })
  {
    jacobian[Name(validity)] = facts.count[static_cast<std::size_t>(validity)];
  }
  for (const Validity validity : { Validity::Inverted, Validity::Undecided })
  {
    jacobian[std::string(Name(validity)) + "_elements"] =
      facts.first[static_cast<std::size_t>(validity)];
  }
  jacobian.update(RangeJson(facts.jacobian));
  summary["jacobian"] = std::move(jacobian);
  summary["certify_seconds"] = facts.seconds;
  for (const CertifiedField& field : facts.fields)
  {
    if (field.isExpression)
    {
      summary["expressions"].push_back({ { "name", field.name }, { "certified", ToJson(field) } });
    }
  }
}

nlohmann::ordered_json ToJson(const CertifiedField& field)
{
  nlohmann::ordered_json object;
  for (const MeshRange& range : field.components)
  {
    object["components"].push_back(RangeJson(range));
  }
  if (field.magnitude)
  {
    object["magnitude"] = RangeJson(*field.magnitude);
  }
  if (field.gradient)
  {
    object["gradient_magnitude"] = RangeJson(*field.gradient);
  }
  return object;
}
} // namespace pixelexact
