// SPDX-License-Identifier: BSD-3-Clause
// Coefficients through VTK's files, bit for bit.
#include "Support.h"

#include "HighOrderModel.h"

#include "vtkUnstructuredGridReader.h"
#include "vtkUnstructuredGridWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <unistd.h>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

class Files : public ::testing::Test
{
protected:
  vtkSmartPointer<vtkHighOrderGrid> Grid =
    Converted(ReadGrid(std::filesystem::path(PIXELEXACT_DATA_DIR) / "toroid_prism_g3_p4.vtu"));
  std::filesystem::path File = std::filesystem::temp_directory_path() /
    ("pixelexact-" + std::to_string(getpid()) + "-" +
      ::testing::UnitTest::GetInstance()->current_test_info()->name());

  ~Files() override { std::filesystem::remove(File); }

  void ExpectSame(vtkUnstructuredGrid* other)
  {
    ASSERT_EQ(vtkHighOrderGrid::CheckCoefficients(other), "");
    const auto a = HighOrderModel::From(Grid);
    const auto b = HighOrderModel::From(other);
    const auto same = [](const Expansion& x, const Expansion& y)
    {
      return std::ranges::equal(x.coefficients, y.coefficients) &&
        std::ranges::equal(x.offset, y.offset) && std::ranges::equal(x.spaceOf, y.spaceOf) &&
        std::ranges::equal(x.spaces, y.spaces) && x.components == y.components;
    };
    EXPECT_TRUE(same(a->GetMesh().map, b->GetMesh().map));
    EXPECT_TRUE(std::ranges::equal(a->GetMesh().centre, b->GetMesh().centre));
    EXPECT_TRUE(std::ranges::equal(a->GetMesh().size, b->GetMesh().size));
    EXPECT_TRUE(std::ranges::equal(a->GetMesh().uncertainty, b->GetMesh().uncertainty));
    EXPECT_TRUE(std::ranges::equal(a->SourceCells(), b->SourceCells()));
    ASSERT_EQ(a->Fields().size(), b->Fields().size());
    for (const auto& field : a->Fields())
    {
      const Field* twin = b->FindField(field.name);
      ASSERT_NE(twin, nullptr) << field.name;
      EXPECT_TRUE(same(field.values, twin->values)) << field.name;
    }
  }

  void ThroughXml(int mode, bool compress)
  {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(Grid);
    writer->SetFileName(File.c_str());
    writer->SetDataMode(mode);
    if (compress)
    {
      writer->SetCompressorTypeToZLib();
    }
    else
    {
      writer->SetCompressorTypeToNone();
    }
    ASSERT_EQ(writer->Write(), 1);
    ExpectSame(ReadGrid(File));
  }
  void ThroughLegacy(int type)
  {
    vtkNew<vtkUnstructuredGridWriter> writer;
    writer->SetInputData(Grid);
    writer->SetFileName(File.c_str());
    writer->SetFileType(type);
    ASSERT_EQ(writer->Write(), 1);
    vtkNew<vtkUnstructuredGridReader> reader;
    reader->SetFileName(File.c_str());
    reader->ReadAllFieldsOn();
    reader->Update();
    ExpectSame(reader->GetOutput());
  }
};

TEST_F(Files, XmlAscii)
{
  ThroughXml(vtkXMLWriter::Ascii, false);
}
TEST_F(Files, XmlBinary)
{
  ThroughXml(vtkXMLWriter::Binary, false);
}
TEST_F(Files, XmlAppended)
{
  ThroughXml(vtkXMLWriter::Appended, true);
}
TEST_F(Files, LegacyBinary)
{
  ThroughLegacy(VTK_BINARY);
}
} // namespace
