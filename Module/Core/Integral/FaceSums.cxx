// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/FaceSums.h"

#include "Core/Element/Validity.h"
#include "Core/Integral/FaceIntegral.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace pixelexact
{
namespace
{
/// The number of rounds, each with widths from the magnitudes of the round before.
constexpr int kRounds = 4;
/// Boxes per face. Integrands on a face are smooth.
constexpr std::int64_t kFaceBoxes = 4096;
} // namespace

SurfaceIntegral OverFaces(const IntegralQuestion& question, std::span<const SeenFace> faces,
  const IntegralEffort& effort, const Deadline& deadline)
{
  SurfaceIntegral result;
  result.faces = static_cast<std::int64_t>(faces.size());
  Rounds rounds(question.Quantities(), effort);
  struct OfFace
  {
    Sums sums;
    std::vector<double> magnitudes;
    bool finite = true;
    bool valid = true;
  };
  std::vector<OfFace> parts(faces.size());
  const std::vector<double> nothing(question.Quantities(), 0.0);
  for (int round = 0;; ++round)
  {
    const std::vector<double> allowed = round == 0
      ? std::vector<double>(question.Quantities(), std::numeric_limits<double>::infinity())
      : rounds.Share(faces.size());
    tbb::parallel_for(std::size_t{ 0 }, faces.size(),
      [&](std::size_t k)
      {
        OfFace& part = parts[k];
        if (round > 0 && (!part.finite || IsWithin(part.sums, allowed) || deadline.IsOver()))
        {
          return;
        }
        ElementFunctions functions(question, faces[k].face.element);
        part.magnitudes = nothing;
        part.finite = functions.IsFinite();
        part.sums = part.finite ? IntegrateFace(functions, faces[k].face.face, allowed,
                                    std::min(effort.boxes, kFaceBoxes), part.magnitudes)
                                : Sums(question.Quantities());
        DropZeroField(functions, part.sums);
        if (question.HasFlux() && faces[k].sense < 0.0)
        {
          part.sums.back() = -part.sums.back();
        }
        if (round == 0)
        {
          part.valid = ValidityOf(question.mesh, faces[k].face.element).validity == Validity::Valid;
        }
      });
    result.sums.assign(question.Quantities(), {});
    rounds.Magnitudes = nothing;
    result.notFinite = 0;
    result.notValid = 0;
    for (const OfFace& part : parts)
    {
      result.notFinite += part.finite ? 0 : 1;
      result.notValid += part.valid ? 0 : 1;
      AddTo(result.sums, part.sums);
      for (std::size_t q = 0; q < nothing.size(); ++q)
      {
        rounds.Magnitudes[q] += part.magnitudes[q];
      }
    }
    result.met = rounds.IsMet(result.sums);
    if (result.met || round == kRounds || deadline.IsOver())
    {
      break;
    }
  }
  result.magnitudes = rounds.Magnitudes;
  result.timeIsOver = deadline.IsOver() && !result.met;
  return result;
}
} // namespace pixelexact
