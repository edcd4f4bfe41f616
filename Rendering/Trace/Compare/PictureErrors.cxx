// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Compare/PictureErrors.h"

#include "Core/Base/Error.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{

/// For each place p, the least of (p - q)^2 + values[q]: the lower envelope of parabolas. Values
/// are `stride` apart.
class Envelope
{
public:
  explicit Envelope(std::size_t most)
    : Roots(most)
    , Begins(most + 1)
    , Line(most)
  {
  }

  void Apply(double* values, std::size_t count, std::size_t stride)
  {
    for (std::size_t q = 0; q < count; ++q)
    {
      Line[q] = values[q * stride];
    }
    std::size_t used = 0;
    for (std::size_t q = 0; q < count; ++q)
    {
      if (Line[q] < kInfinity)
      {
        Add(q, used);
      }
    }
    std::size_t k = 0;
    for (std::size_t p = 0; p < count; ++p)
    {
      while (k + 1 < used && Begins[k + 1] < static_cast<double>(p))
      {
        ++k;
      }
      const double away =
        used > 0 ? static_cast<double>(p) - static_cast<double>(Roots[k]) : kInfinity;
      values[p * stride] = used > 0 ? away * away + Line[Roots[k]] : kInfinity;
    }
  }

private:
  void Add(std::size_t q, std::size_t& used)
  {
    const auto height = [this](std::size_t root)
    { return Line[root] + static_cast<double>(root) * static_cast<double>(root); };
    double begin = -kInfinity;
    while (used > 0)
    {
      const std::size_t last = Roots[used - 1];
      begin = (height(q) - height(last)) / (2.0 * static_cast<double>(q - last));
      if (begin > Begins[used - 1])
      {
        break;
      }
      --used;
    }
    Begins[used] = used == 0 ? -kInfinity : begin;
    Roots[used] = q;
    ++used;
  }

  std::vector<std::size_t> Roots; ///< where parabolas stand
  std::vector<double> Begins;     ///< from where on each is the lowest
  std::vector<double> Line;
};
} // namespace

std::vector<double> DistanceToMarked(
  std::span<const std::uint8_t> pixels, std::uint8_t mark, int width, int height)
{
  const auto across = static_cast<std::size_t>(width);
  const auto up = static_cast<std::size_t>(height);
  std::vector<double> squares(pixels.size());
  std::ranges::transform(pixels, squares.begin(),
    [mark](std::uint8_t pixel) { return pixel == mark ? 0.0 : kInfinity; });
  Envelope envelope(std::max(across, up));
  for (std::size_t row = 0; row < up; ++row)
  {
    envelope.Apply(&squares[row * across], across, 1);
  }
  for (std::size_t column = 0; column < across; ++column)
  {
    envelope.Apply(&squares[column], up, across);
  }
  std::ranges::transform(squares, squares.begin(), [](double square) { return std::sqrt(square); });
  return squares;
}

namespace
{
constexpr auto kIn = static_cast<std::uint8_t>(ContourVerdict::In);
constexpr auto kOut = static_cast<std::uint8_t>(ContourVerdict::Out);

int BinOf(double value, const ErrorMeasure& measure)
{
  const double length = measure.range[1] - measure.range[0];
  const double part = length > 0.0 ? (value - measure.range[0]) / length : 0.0;
  return std::clamp(
    static_cast<int>(std::floor(std::clamp(part, 0.0, 1.0) * measure.bins)), 0, measure.bins - 1);
}

/// The value that this share of `values` does not exceed.
double Quantile(std::vector<double>& values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const double rank = std::ceil(share * static_cast<double>(values.size())) - 1.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 0.0));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void CompareContours(const Picture& truth, const Picture& other, PictureErrors& errors)
{
  errors.hasContours = !truth.contour.empty() && !other.contour.empty();
  if (!errors.hasContours)
  {
    return;
  }
  const std::vector<double> toOther =
    DistanceToMarked(other.contour, kIn, other.width, other.height);
  const std::vector<double> toTruth =
    DistanceToMarked(truth.contour, kIn, truth.width, truth.height);
  for (std::size_t i = 0; i < truth.contour.size(); ++i)
  {
    if (truth.contour[i] == kIn)
    {
      ++errors.contourPixels;
      if (other.contour[i] == kOut)
      {
        errors.contourFarthest = std::max(errors.contourFarthest, toOther[i]);
        ++(toOther[i] <= kNearbyPixels ? errors.contourDisplaced : errors.contourMissed);
      }
    }
    else if (truth.contour[i] == kOut && other.contour[i] == kIn && toTruth[i] > kNearbyPixels)
    {
      ++errors.contourInvented;
    }
  }
}
} // namespace

Picture PictureOf(const Frame& frame, std::span<const std::uint8_t> contours)
{
  return { frame.width, frame.height, frame.centres.value, frame.centres.verdict,
    { contours.begin(), contours.end() } };
}

Picture PictureOf(int width, int height, std::vector<double> centres,
  std::span<const double> corners, std::span<const double> isoValues)
{
  Picture picture{ width, height, std::move(centres), {}, {} };
  picture.verdict.resize(picture.Size());
  std::ranges::transform(picture.value, picture.verdict.begin(),
    [](double value) { return std::isnan(value) ? kNothingPixel : kExactPixel; });
  if (corners.empty())
  {
    return picture;
  }
  picture.contour.assign(picture.Size(), kOut);
  const auto across = static_cast<std::size_t>(width);
  for (std::size_t i = 0; i < picture.Size(); ++i)
  {
    const std::size_t first = i / across * (across + 1) + i % across;
    double least = kInfinity;
    double most = -kInfinity;
    for (const std::size_t corner : { first, first + 1, first + across + 1, first + across + 2 })
    {
      least = std::fmin(least, corners[corner]);
      most = std::fmax(most, corners[corner]);
    }
    const bool crossed =
      std::ranges::any_of(isoValues, [&](double value) { return least <= value && value <= most; });
    picture.contour[i] = crossed ? kIn : kOut;
  }
  return picture;
}

PictureErrors Compare(const Picture& truth, const Picture& other, const ErrorMeasure& measure)
{
  if (truth.width != other.width || truth.height != other.height)
  {
    throw Error("pictures of different sizes cannot be compared; make them of one size.");
  }
  PictureErrors errors;
  std::vector<double> misses;
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.Size(); ++i)
  {
    const bool hasValue = other.verdict[i] == kExactPixel && std::isfinite(other.value[i]);
    if (truth.verdict[i] != kExactPixel || !std::isfinite(truth.value[i]))
    {
      errors.invented +=
        truth.verdict[i] == kNothingPixel && other.verdict[i] == kExactPixel ? 1 : 0;
      continue;
    }
    ++errors.shown;
    if (!hasValue)
    {
      ++errors.missing;
      misses.push_back(kInfinity);
      continue;
    }
    ++errors.compared;
    const double miss = std::fabs(other.value[i] - truth.value[i]);
    misses.push_back(miss);
    sum += miss;
    errors.largest = std::max(errors.largest, miss);
    errors.wrongBin += BinOf(other.value[i], measure) != BinOf(truth.value[i], measure) ? 1 : 0;
  }
  errors.mean = errors.compared > 0 ? sum / static_cast<double>(errors.compared) : 0.0;
  errors.atShare = Quantile(misses, measure.share);
  CompareContours(truth, other, errors);
  return errors;
}
} // namespace pixelexact
