// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/SurfaceDomain.h"

#include "Cuts/IntegralPieces.h"
#include "Cuts/IntegralRows.h"
#include "HighOrderModel.h"

#include "Core/Integral/IntegralCut.h"

#include <vector>

namespace pixelexact
{
SurfaceDomain DomainOfPatches(std::span<const SurfacePatch> patches,
  std::span<const ImplicitPolynomial> clips, const HighOrderModel& model)
{
  return { [=, &model](
             const Field* field, const IntegralEffort& effort, std::optional<double> below)
    {
      return IntegratePatches(
        { model.GetMesh(), field, nullptr, {}, below }, patches, clips, model, effort);
    },
    [=, &model](const Field& field, int component)
    {
      SurfaceExtremes found;
      found.extremes.met = true;
      for (const SurfacePatch& patch : patches)
      {
        std::vector<ImplicitPolynomial> all = patch.clips;
        all.insert(all.end(), clips.begin(), clips.end());
        const PolynomialSurface surface(patch.surface);
        IntegralQuestion question{ model.GetMesh(), &field, &surface, all };
        question.within = patch.within;
        found.Add(FindExtremesOnCut(question, component, model.GetLocator(), model.Faces()));
      }
      return found;
    } };
}

SurfaceDomain DomainOfCut(
  const IntegralCut& cut, std::span<const ImplicitPolynomial> clips, const HighOrderModel& model)
{
  return { [=, &cut, &model](
             const Field* field, const IntegralEffort& effort, std::optional<double> below)
    {
      return IntegrateCut(
        { model.GetMesh(), field, &cut, clips, below }, model.GetLocator(), model.Faces(), effort);
    },
    [=, &cut, &model](const Field& field, int component)
    {
      return FindExtremesOnCut(
        { model.GetMesh(), &field, &cut, clips }, component, model.GetLocator(), model.Faces());
    } };
}

SurfaceDomain DomainOfBoundary(std::span<const std::int32_t> attributes,
  std::span<const ImplicitPolynomial> clips, const HighOrderModel& model)
{
  return { [=, &model](
             const Field* field, const IntegralEffort& effort, std::optional<double> below)
    {
      return IntegrateBoundary(
        { model.GetMesh(), field, nullptr, clips, below }, attributes, model, effort);
    },
    [=, &model](const Field& field, int component)
    {
      return FindExtremesOnFaces(
        { model.GetMesh(), &field, nullptr, clips }, component, BoundaryOf(model, attributes));
    } };
}
} // namespace pixelexact
