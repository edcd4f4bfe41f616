// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Location/Sample.h"

namespace pixelexact
{
/// Kernel output arrays, grown as needed.
class OutputArrays
{
public:
  double* const* Get(std::size_t arrays, std::size_t stride);

private:
  std::vector<double> Storage;
  std::vector<double*> Pointers;
};

/// Writes the results of a locator for `points`, and the field's values there. `field` may be null;
/// without enclosures `points` are not read. All must outlive the sink.
class SamplingSink final : public LocationSink
{
public:
  SamplingSink(
    const Mesh& mesh, const Field* field, const LanePoints& points, const SampleTarget& target);

  void Inside(int element, std::span<const int> index, const double* const xi[3],
    const double* residual) override;
  void Unknown(int index, int element) override;

private:
  void EvaluateField(int element, std::span<const int> index, const LanePoints& xi);
  /// `slopes`: null, or where gradients go.
  void EvaluatePolynomials(
    int element, const LanePoints& xi, double* const* out, double* const* slopes);
  void CheckFloats(int element, const LanePoints& xi, const double* const* values);
  void EncloseField(int element, std::span<const int> index, const LanePoints& xi);

  const Mesh& mesh_;
  const Field* field_;
  LanePoints Points;
  const SampleTarget& Target;
  OutputArrays Arrays;
  OutputArrays Checked;
  OutputArrays Places;
  OutputArrays Normals;
};

/// Throws Error unless the target's arrays are empty or fit the points and the field.
void RequireSizes(const Field* field, std::size_t points, const SampleTarget& target);
} // namespace pixelexact
