// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/MeshPieces.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Formats/FileText.h"
#include "Formats/Gmsh/FileSet.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

namespace pixelexact::gmsh
{
namespace
{
namespace fs = std::filesystem;

/// "folder/NAME_12.msh.gz" is "folder/NAME_", 12 and ".msh.gz".
struct NumberedName
{
  std::string before;
  int number = 0;
  std::string behind;

  [[nodiscard]] std::string Of(std::size_t other) const
  {
    return before + std::to_string(other) + behind;
  }
};

std::optional<NumberedName> SplitName(const std::string& path)
{
  const std::size_t folder = path.rfind('/') + 1;
  const std::size_t dot = path.find('.', folder);
  const std::size_t bar = path.rfind('_', dot);
  if (bar == std::string::npos || bar < folder)
  {
    return std::nullopt;
  }
  NumberedName name{ path.substr(0, bar + 1), 0,
    dot == std::string::npos ? std::string() : path.substr(dot) };
  const std::string_view digits =
    std::string_view(path).substr(bar + 1, std::min(dot, path.size()) - bar - 1);
  if (digits.starts_with('0') || !ParseWhole(digits, name.number) || name.number < 1)
  {
    return std::nullopt;
  }
  return name;
}

bool IsFile(const std::string& path)
{
  std::error_code failure;
  return fs::is_regular_file(path, failure);
}

Partitions PartitionsOf(const std::string& path)
{
  const FileText text(path);
  FileSet set({ { path, text.Get(), &text } });
  return set.ReadPartitions();
}

/// Whether a file holds one partition, the one that its name counts.
bool HoldsOwn(const Partitions& partitions, std::size_t number)
{
  return partitions.here.size() == 1 && std::cmp_equal(*partitions.here.begin(), number);
}

/// The same for a file that the user did not name: an unreadable one does not count.
bool HoldsOwn(const std::string& path, std::size_t number)
{
  try
  {
    return HoldsOwn(PartitionsOf(path), number);
  }
  catch (const Error&)
  {
    return false;
  }
}

/// The number of the last file, counting on from `number`. 0: no other file belongs to this one.
std::size_t CountFiles(const NumberedName& name)
{
  auto count = static_cast<std::size_t>(name.number);
  while (IsFile(name.Of(count + 1)))
  {
    ++count;
  }
  for (std::size_t i = 1; i <= count; ++i)
  {
    if (std::cmp_not_equal(i, name.number) && IsFile(name.Of(i)))
    {
      return HoldsOwn(name.Of(i), i) ? count : 0;
    }
  }
  return 0;
}
} // namespace

std::vector<std::string> PiecesOf(const std::string& path)
{
  const auto name = SplitName(path);
  std::vector<std::string> alone{ path };
  if (!name || !IsFile(path) || (!IsFile(name->Of(1)) && !IsFile(name->Of(2))))
  {
    return alone;
  }
  const Partitions partitions = PartitionsOf(path);
  if (!HoldsOwn(partitions, static_cast<std::size_t>(name->number)) || partitions.all == 1)
  {
    return alone;
  }
  const std::size_t count = partitions.all > 0 ? partitions.all : CountFiles(*name);
  if (count == 0)
  {
    return alone;
  }
  std::vector<std::string> pieces;
  for (std::size_t i = 1; i <= count; ++i)
  {
    pieces.push_back(name->Of(i));
    if (!IsFile(pieces.back()))
    {
      throw InvalidData(path + ": it is one of " + std::to_string(count) +
        " partitions of a mesh, and " + pieces.back() +
        " is missing; put all of them in one "
        "folder.");
    }
  }
  return pieces;
}

void MeshUnion::Add(MeshFile&& piece, const std::string& name)
{
  if (HasPiece && piece.dimension != Whole.dimension)
  {
    throw InvalidData(name + ": its elements are " + std::to_string(piece.dimension) +
      "-D, those of the partitions before it " + std::to_string(Whole.dimension) +
      "-D; they are no parts of one mesh.");
  }
  HasPiece = true;
  Whole.dimension = piece.dimension;
  std::vector<std::int32_t> nodeOf(piece.nodes);
  piece.nodeOf.ForEach(
    [&](std::uint64_t tag, std::int32_t node)
    {
      const auto next = static_cast<std::int32_t>(Whole.positions.size() / 3);
      const auto [known, isNew] = NodeOf.try_emplace(tag, next);
      nodeOf[static_cast<std::size_t>(node)] = known->second;
      const double* x = &piece.positions[3 * static_cast<std::size_t>(node)];
      if (isNew)
      {
        Whole.positions.insert(Whole.positions.end(), x, x + 3);
      }
      else if (!std::equal(x, x + 3, &Whole.positions[3 * static_cast<std::size_t>(known->second)]))
      {
        throw InvalidData(name + ": node " + std::to_string(tag) +
          " is elsewhere than in the partitions before it; they are of different meshes: remove "
          "what an earlier run has left.");
      }
    });
  const auto firstElement = static_cast<std::int32_t>(Whole.elements.size());
  piece.elementOf.ForEach([&](std::uint64_t tag, std::int32_t element)
    { Whole.elementOf.Add(tag, firstElement + element); });
  const std::size_t firstNode = Whole.elementNodes.size();
  for (Solid& element : piece.elements)
  {
    element.firstNode += firstNode;
    Whole.elements.push_back(element);
  }
  const auto toWhole = [&nodeOf](std::int32_t node)
  { return node < 0 ? node : nodeOf[static_cast<std::size_t>(node)]; };
  std::ranges::transform(piece.elementNodes, std::back_inserter(Whole.elementNodes), toWhole);
  for (SurfaceElement& face : piece.faces)
  {
    std::ranges::transform(face.corners, face.corners.begin(), toWhole);
    auto corners = face.corners;
    std::ranges::sort(corners);
    if (Faces.emplace(corners, std::pair(face.physical, face.entity)).second)
    {
      Whole.faces.push_back(face);
    }
  }
  for (PhysicalName& physical : piece.names)
  {
    const bool known = std::ranges::any_of(Whole.names,
      [&](const PhysicalName& other)
      { return other.dimension == physical.dimension && other.tag == physical.tag; });
    if (!known)
    {
      Whole.names.push_back(std::move(physical));
    }
  }
  Whole.lower += piece.lower;
  Whole.inSeveralGroups += piece.inSeveralGroups;
  Whole.partitions = std::max(Whole.partitions, piece.partitions);
  Whole.partitionsHere.insert(piece.partitionsHere.begin(), piece.partitionsHere.end());
}

MeshFile MeshUnion::Finish()
{
  Whole.nodes = Whole.positions.size() / 3;
  Whole.nodeOf.Reserve(NodeOf.size());
  for (const auto& [tag, node] : NodeOf)
  {
    Whole.nodeOf.Add(tag, node);
  }
  static_cast<void>(Whole.nodeOf.Finish()); // each is there once
  if (const auto* twice = Whole.elementOf.Finish())
  {
    throw InvalidData("element " + std::to_string(*twice) +
      " is in two partitions of the mesh; they are of different meshes: remove what an earlier run "
      "has left.");
  }
  return std::move(Whole);
}
} // namespace pixelexact::gmsh
