// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/BehindFace.h"
#include "Core/Faces/FacePlaces.h"

#include <cstddef>
#include <map>
#include <vector>

namespace pixelexact
{
class FaceTable;
class Locator;
struct Mesh;

/// The elements behind the Gauss points of a face that meets parts of others.
struct ManyBehind
{
  std::vector<BehindFace> behind;
  std::vector<ElementFace> faces; ///< on which these points lie
  bool isNested = false;          ///< all of the face lies on one other face
};

/// What lies behind the faces of a mesh that meet parts of several others, at the Gauss points of
/// an order: `order` and the map's together.
class FacesBehind
{
public:
  /// All of the arguments must outlive it.
  FacesBehind(
    const Locator& locator, const FaceTable& table, const PlacesByOrder& places, int order);

  /// Finds them for an element. Threads may find those of different elements at the same time.
  void Find(int element);
  /// Null for faces that meet one other face, or none.
  [[nodiscard]] const ManyBehind* Of(const ElementFace& face) const;

private:
  [[nodiscard]] ManyBehind BehindAll(const ElementFace& face) const;
  [[nodiscard]] ElementFace FaceAt(int element, const Vec3& xi) const;

  const Locator& locator_;
  const FaceTable& Table;
  const PlacesByOrder& Places;
  const Mesh& mesh_;
  int Order;
  std::vector<std::map<int, ManyBehind>> Many; ///< by element, by face
};
} // namespace pixelexact
