// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"
#include "Formats/Nektar/Files/XmlBlocks.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pixelexact::nektar
{
/// Reads a file's text into `xml`, in place where it is a FileText's: UTF-8, UTF-16, UTF-32 or,
/// where declared, Latin-1. As in Nektar++'s own parser, a document type is skipped, and entities
/// other than XML's five stand for themselves. Errors that this parser tolerates are repaired, with
/// a line in `notes` each. Refused are errors at which it stops, and contents that it would drop
/// silently: text outside of elements, attributes that occur twice, declarations within a document
/// type. Throws InvalidData ("<file>, line <n>: ...") and, for HDF5, Unsupported. Returns the long
/// blocks that marks replace (XmlBlocks.h).
std::vector<std::string_view> LoadXml(
  const NamedText& file, pugi::xml_document& xml, std::vector<std::string>& notes);

/// A Nektar++ XML file, as LoadXml takes it.
class Document
{
public:
  /// Throws InvalidData ("<file>: ...") where the file is not XML or has no NEKTAR element.
  explicit Document(const NamedText& file);
  ~Document();
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  [[nodiscard]] pugi::xml_node Root() const { return Xml.child("NEKTAR"); }
  [[nodiscard]] const std::string& Name() const { return FileName; }
  /// Its name without folders.
  [[nodiscard]] std::string BaseName() const { return FileName.substr(FileName.rfind('/') + 1); }

  /// Notes on repairs of the file's XML, as in SolverModel::notes.
  [[nodiscard]] const std::vector<std::string>& Notes() const { return RepairNotes; }

  /// The only child of a tag, or none; fails where there are several.
  [[nodiscard]] pugi::xml_node Only(const pugi::xml_node& parent, const char* tag) const;
  /// An element's own text, without comments.
  [[nodiscard]] static std::string Text(const pugi::xml_node& node);

  /// "<file>, <TAG ID=...>".
  [[nodiscard]] std::string Place(const pugi::xml_node& node) const;
  [[noreturn]] void Fail(const pugi::xml_node& node, const std::string& problem) const;
  [[noreturn]] void FailUnsupported(const pugi::xml_node& node, const std::string& problem) const;

  /// Whether the element's text is a compressed block; fails for unknown forms.
  [[nodiscard]] bool IsCompressed(const pugi::xml_node& node) const;
  /// The same for the coefficients of fields, which are compressed unless the file states
  /// otherwise.
  [[nodiscard]] bool IsCompressedField(const pugi::xml_node& node) const;
  /// The fixed-size records of a compressed block, at most `most` of them.
  template <class Record>
  std::vector<Record> Records(const pugi::xml_node& node, std::size_t most) const
  {
    std::vector<Record> records;
    PassRecords<Record>(node, most,
      [&records, most](std::span<const Record> some, std::size_t packed)
      {
        // Numbers are rarely compressed to less than a quarter. Reserved memory that is not written
        // costs nothing.
        if (records.empty())
        {
          records.reserve(std::min(most, 4 * packed / sizeof(Record)) + some.size());
        }
        records.insert(records.end(), some.begin(), some.end());
      });
    return records;
  }
  /// Passes records in batches, with the number of bytes of the compressed text.
  template <class Record, class Pass>
  void PassRecords(const pugi::xml_node& node, std::size_t most, Pass&& pass) const
  {
    std::string joined;
    const std::string_view text = TextView(node, joined);
    Decompressor stream(text, std::min(most * sizeof(Record), MostExpanded), Place(node), File);
    constexpr std::size_t kTogether = 8192;
    std::vector<Record> some(kTogether);
    std::size_t bytes = kTogether * sizeof(Record);
    while (bytes == kTogether * sizeof(Record))
    {
      bytes = stream.Read(std::as_writable_bytes(std::span(some)));
      if (bytes % sizeof(Record) != 0)
      {
        Fail(node,
          "the compressed data hold " + std::to_string(stream.Given()) +
            " bytes, which is no multiple of a record's " + std::to_string(sizeof(Record)) +
            "; the file is damaged.");
      }
      pass(std::span<const Record>(some).first(bytes / sizeof(Record)), text.size());
    }
  }

  /// Returns the whole numbers in an element's text; fails unless there are `count` of them.
  std::vector<std::int64_t> Integers(const pugi::xml_node& node, std::size_t count) const;
  /// Returns the numbers in an element's text.
  std::vector<double> Numbers(const pugi::xml_node& node) const;
  /// Returns an attribute that must be a whole number and not negative.
  std::int64_t Id(const pugi::xml_node& node, const char* attribute) const;
  /// Returns the numbers of a list such as "0-65,70"; fails for more than `most` numbers.
  std::vector<std::int64_t> List(
    const pugi::xml_node& node, std::string_view text, std::size_t most) const;

  /// Limit of the bytes of an expanded block: a thousand times the file, which is zlib's limit.
  [[nodiscard]] std::size_t MostBytes() const { return MostExpanded; }

private:
  /// Returns Text() without a copy where it is in one piece, else stores it in `joined`.
  std::string_view TextView(const pugi::xml_node& node, std::string& joined) const;

  std::string FileName;
  const FileText* File;
  pugi::xml_document Xml;
  std::vector<std::string> RepairNotes;
  std::vector<std::string_view> Blocks; ///< the long ones, which Xml has marks for
  std::size_t MostExpanded;
};
} // namespace pixelexact::nektar
