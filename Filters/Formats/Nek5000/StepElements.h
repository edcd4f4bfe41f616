// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"
#include "Formats/Nek5000/Header.h"

#include <span>
#include <vector>

namespace pixelexact::nek5000
{
/// The values of a field at an element's nodes.
struct Block
{
  int before = 0; ///< components of other fields that stand before it in the file
  int components = 1;
};

/// The elements of one step, by their numbers in the whole mesh. Their values stay in the files'
/// texts.
class StepElements
{
public:
  /// `files`: all parts of the step, in their order; they outlive the object. Throws InvalidData or
  /// Unsupported, with the file's name and the remedy, where a file is damaged or they do not
  /// belong together, or where elements are missing or occur twice.
  explicit StepElements(const std::vector<NamedText>& files);

  [[nodiscard]] std::size_t Count() const { return Places.size(); }
  /// The header of the first file. Orders, fields and counts of all elements are those of all
  /// files.
  [[nodiscard]] const Header& GetHeader() const { return Files.front().header; }
  /// Whether a file has values of single precision.
  [[nodiscard]] bool IsSingle() const;
  /// The element's file and number, for messages.
  [[nodiscard]] std::string Describe(std::size_t element) const;

  /// Copies a block's values at the nodes of an element, component by component. Elements count
  /// from 0 in the order of their numbers, which count from 1. Safe to call from several threads.
  void Gather(const Block& block, std::size_t element, std::span<double> values) const;

  /// Releases the memory of the files' texts; later accesses read the files.
  void Forget() const;

private:
  struct File
  {
    NamedText text;
    Header header;
  };
  struct Place
  {
    std::int32_t file = -1; ///< -1: not found yet
    std::int32_t element = 0;
  };

  void AddElements(std::size_t file);

  std::vector<File> Files;
  std::vector<Place> Places; ///< by number
};
} // namespace pixelexact::nek5000
