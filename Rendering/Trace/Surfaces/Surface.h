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

/// A cut-surface: where rays meet it (paper, section 5.1.1). One file each. Two kinds: a space
/// surface knows no mesh; a mesh surface is made of elements, and tells its hits' element and xi
/// (HitSlots::Elements).
class Surface
{
public:
  virtual ~Surface() = default;

  /// All hits of each ray with tNear <= t <= tFar, once each, in order. Called from several threads
  /// at once (but see NeedsCallingThread), with some rays of a tile, which are neighbours in the
  /// image. A ray's hits depend on that ray alone. What it throws ends the frame.
  virtual void Meet(const RayLanes& rays, HitSlots& hits) const = 0;

  /// The unit normal at a point of the surface that Meet found, on either side.
  [[nodiscard]] virtual Vec3 Normal(const SurfacePoint& point) const = 0;

  /// The same of several points.
  virtual void Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const;

  /// Whether normals are asked for together: many of them cost little more than one.
  [[nodiscard]] virtual bool HasCostlyNormals() const { return NeedsCallingThread(); }

  /// Whether it asks somebody who answers the thread alone that called the tracer, and many
  /// questions as fast as one. All tiles are then traced by that thread, one after the other.
  [[nodiscard]] virtual bool NeedsCallingThread() const { return false; }

  /// Whether its normal is everywhere the same: it is then not lit unless asked for.
  [[nodiscard]] virtual bool IsFlat() const { return false; }

  /// Whether it is a plane without end, which goes on where the mesh ends.
  [[nodiscard]] virtual bool IsPlane() const { return false; }

  /// How far off the straight line between two of its hits, at most, is the surface along the rays
  /// between the two of these hits; all of them then meet it there. Infinite where that is not
  /// known.
  [[nodiscard]] virtual double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const;
  /// How far off the triangle between three of its hits, at most, is the surface along the rays
  /// between these hits' rays; all of them then meet it there. Infinite where that is not known.
  [[nodiscard]] virtual double SagittaOver(
    const std::array<Ray, 3>& rays, const std::array<Vec3, 3>& hits) const;
  /// Whether Sagitta is known anywhere.
  [[nodiscard]] virtual bool HasSagitta() const { return IsFlat(); }

  // What bodies that are made of others ask of their parts' surfaces. Not known unless told.

  /// How far at most the rays of a chord meet the surface from it: along each of them it is
  /// crossed, from one side to the other, exactly once within the room of the chord,
  /// and there, continuously from ray to ray. The chord need not end on the surface. Infinite where
  /// that is not known.
  [[nodiscard]] virtual double Reach(const Chord& chord) const;
  /// Whether no point of the surface lies in a ball.
  [[nodiscard]] virtual bool IsClearOf(const Vec3& centre, double radius) const;

  /// Whether some point of the surface may be in a flat polygon widened by `slack`; false: proven
  /// that none is. `work`: what finding that out may spend; null: without a limit.
  [[nodiscard]] virtual bool MayMeet(const Outline& part, double slack, EdgeWork* work) const;

  /// The value of a component (or kMagnitude) of a field on all of the surface, where that is the
  /// same by what the surface is.
  [[nodiscard]] virtual std::optional<double> HeldValue(const Field& field, int component) const;

  /// The surface as zeros of polynomials, part by part, with which contour lines and integrals are
  /// proven; none where there are no such polynomials. Coefficients are rounded to doubles.
  [[nodiscard]] virtual std::vector<SurfacePatch> Implicit() const { return {}; }

  /// Whether all of its points lie in the mesh: rays that cannot see through it end at their first
  /// hit (RayLanes::nearestOnly).
  [[nodiscard]] virtual bool IsOfMesh() const { return false; }

  /// The number, as in FacesOf(shape), of the face of its element that a piece of the surface is;
  /// -1: the surface does not consist of elements' faces.
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
