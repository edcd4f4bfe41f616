// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ImplicitPolynomial.h"
#include "Core/Questions/Outline.h"
#include "Trace/Camera.h"
#include "Trace/Rays.h"
#include "Trace/Surfaces/Chord.h"
#include "Trace/Surfaces/HitSlots.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
class EdgeWork;
struct Field;

/// A cut-surface, and its intersection with rays (paper, section 5.1.1). There are two kinds. A
/// space surface does not depend on a mesh. A mesh surface consists of parts of elements and stores
/// element and xi of each hit (HitSlots::Elements).
class Surface
{
public:
  virtual ~Surface() = default;

  /// Finds all hits of each ray with tNear <= t <= tFar, once and in order of t. The rays are
  /// neighbours in the image. Called from several threads at once, except as NeedsCallingThread
  /// states. A ray's hits depend on that ray alone. An exception ends the frame.
  virtual void Meet(const RayLanes& rays, HitSlots& hits) const = 0;

  /// The unit normal, in either direction, at a point that Meet found.
  [[nodiscard]] virtual Vec3 Normal(const SurfacePoint& point) const = 0;

  /// The unit normals at several points.
  virtual void Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const;

  /// Normals are requested in batches, because one call for many costs little more than for one.
  [[nodiscard]] virtual bool HasCostlyNormals() const { return NeedsCallingThread(); }

  /// Must be evaluated on the thread that called the tracer (Python callbacks). That thread then
  /// traces all tiles, one after the other.
  [[nodiscard]] virtual bool NeedsCallingThread() const { return false; }

  /// The normal is the same everywhere; such a surface is lit only on request.
  [[nodiscard]] virtual bool IsFlat() const { return false; }

  /// The surface is an infinite plane, which continues outside the mesh.
  [[nodiscard]] virtual bool IsPlane() const { return false; }

  /// Largest distance, along the rays between those of two hits, of the surface from the straight
  /// line between the hits. All these rays then meet the surface within it. Infinite if no bound is
  /// proven.
  [[nodiscard]] virtual double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const;
  /// Largest distance, along the rays between those of three hits, of the surface from the triangle
  /// between the hits. All these rays then meet the surface within it. Infinite if no bound is
  /// proven.
  [[nodiscard]] virtual double SagittaOver(
    const std::array<Ray, 3>& rays, const std::array<Vec3, 3>& hits) const;
  /// Sagitta is finite for some hits.
  [[nodiscard]] virtual bool HasSagitta() const { return IsFlat(); }

  // Bounds for bodies that combine surfaces. By default, none is proven.

  /// Largest distance from a chord at which the chord's rays meet the surface. Each ray crosses the
  /// surface from one side to the other exactly once within the chord's room, and the place is a
  /// continuous function of the ray. The chord need not end on the surface. Infinite if this is not
  /// proven.
  [[nodiscard]] virtual double Reach(const Chord& chord) const;
  /// No point of the surface lies in the ball.
  [[nodiscard]] virtual bool IsClearOf(const Vec3& centre, double radius) const;

  /// Some point of the surface may lie in a flat polygon widened by `slack`; false if it is proven
  /// that none does. `work`: work budget; null: unlimited.
  [[nodiscard]] virtual bool MayMeet(const Outline& part, double slack, EdgeWork* work) const;

  /// The value of a field's component (or kMagnitude) on all of the surface, if the surface's
  /// definition makes it constant.
  [[nodiscard]] virtual std::optional<double> HeldValue(const Field& field, int component) const;

  /// The surface as zeros of polynomials, part by part, for the proofs of contour lines and
  /// integrals; empty if there are no such polynomials. Coefficients are rounded to doubles.
  [[nodiscard]] virtual std::vector<SurfacePatch> Implicit() const { return {}; }

  /// All points lie in the mesh, so rays that end at opaque layers need only their first hit
  /// (RayLanes::nearestOnly).
  [[nodiscard]] virtual bool IsOfMesh() const { return false; }

  /// The face, numbered as in FacesOf(shape), of its element that a piece of the surface is; -1:
  /// the surface does not consist of elements' faces.
  [[nodiscard]] virtual int FaceOf(std::int32_t /*piece*/) const { return -1; }
};

struct Hit
{
  double t = kNoHit;
  Vec3 position{ 0.0 };
  HitStatus status = HitStatus::Certain;
};

/// Surface::Meet for one ray.
std::vector<Hit> HitsOf(
  const Surface& surface, const Ray& ray, double tNear = kNearest, double tFar = kFarthest);
} // namespace pixelexact
