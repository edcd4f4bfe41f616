// SPDX-License-Identifier: BSD-3-Clause
// Nektar++'s HDF5 files against the same meshes and fields in XML.
#include "Core/Base/Error.h"
#include "Formats/FileText.h"
#include "Formats/Hdf5/Hdf5File.h"
#include "Formats/Nektar/Files/FileParts.h"
#include "Formats/Nektar/Reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

namespace pixelexact::testing
{
namespace
{
const std::string kHdf5 = PIXELEXACT_DATA_DIR "/nek_hdf5";

class NektarHdf5 : public ::testing::Test
{
protected:
  void SetUp() override
  {
    try
    {
      OpenHdf5(kHdf5 + "/Tet_channel_m4_per_hdf5.nekg");
    }
    catch (const Unsupported&)
    {
      GTEST_SKIP() << "built without the HDF5 library";
    }
  }

  /// Reads files as vtkNektarReader does.
  SolverModel Load(const std::string& session, const std::string& field = {})
  {
    std::vector<NamedText> sessions{ Text(session) };
    for (const auto& mesh : nektar::MissingMeshes(sessions))
    {
      sessions.push_back(Text(mesh));
    }
    std::vector<NamedText> fields;
    if (!field.empty())
    {
      fields.push_back(Text(field));
    }
    return nektar::Read(sessions, fields);
  }

  std::string Message(const std::vector<NamedText>& sessions)
  {
    try
    {
      nektar::Read(sessions, {});
    }
    catch (const Error& error)
    {
      return error.what();
    }
    return {};
  }

  NamedText Text(const std::string& path)
  {
    Texts.push_back(ReadFileText(path));
    return { path, Texts.back() };
  }

  std::deque<std::string> Texts;
};

std::vector<double> Coefficients(const OwnedExpansion& expansion)
{
  return { expansion.coefficients.begin(), expansion.coefficients.end() };
}

void ExpectSameFields(const SolverModel& a, const SolverModel& b)
{
  ASSERT_EQ(a.fields.size(), b.fields.size());
  for (std::size_t f = 0; f < a.fields.size(); ++f)
  {
    EXPECT_EQ(a.fields[f].name, b.fields[f].name);
    EXPECT_EQ(a.fields[f].basis, b.fields[f].basis);
    EXPECT_EQ(a.fields[f].values.spaceOf, b.fields[f].values.spaceOf);
    EXPECT_EQ(Coefficients(a.fields[f].values), Coefficients(b.fields[f].values));
  }
}
} // namespace

TEST_F(NektarHdf5, MeshesAreThoseOfXml)
{
  const SolverModel xml = Load(kHdf5 + "/Tet_channel_m4_per.xml");
  const SolverModel hdf5 = Load(kHdf5 + "/Tet_channel_m4_per_hdf5.xml");
  EXPECT_EQ(hdf5.mesh.number, xml.mesh.number);
  EXPECT_EQ(hdf5.mesh.attribute, xml.mesh.attribute);
  EXPECT_EQ(hdf5.mesh.boundary.size(), xml.mesh.boundary.size());
  EXPECT_EQ(hdf5.mesh.groups.size(), xml.mesh.groups.size());
  EXPECT_EQ(Coefficients(hdf5.mesh.map), Coefficients(xml.mesh.map));
}

TEST_F(NektarHdf5, AMeshWithoutItsSession)
{
  const SolverModel alone = Load(kHdf5 + "/Tet_channel_m4_per_hdf5.nekg");
  EXPECT_EQ(alone.mesh.number.size(), 6U);
}

TEST_F(NektarHdf5, FieldsAreThoseOfXml)
{
  for (const std::string name : { "nek_tet_varp", "nek_pyramid_curved_p6" })
  {
    const std::string xml = PIXELEXACT_DATA_DIR "/" + name + "/" + name;
    const SolverModel hdf5 = Load(xml + ".xml", kHdf5 + "/" + name + ".fld");
    ExpectSameFields(hdf5, Load(xml + ".xml", xml + ".fld"));
    EXPECT_EQ(hdf5.time, 0.5);
  }
}

TEST_F(NektarHdf5, TimesAndNamesAreReadFromTheHead)
{
  const std::string field = kHdf5 + "/nek_tet_varp.fld";
  EXPECT_EQ(nektar::FieldTime(field), 0.5);
  EXPECT_EQ(nektar::FieldNames(field), std::vector<std::string>{ "u" });
}

TEST_F(NektarHdf5, RefusesWithReasons)
{
  const auto contains = [](const std::string& message, const std::string& part)
  { EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message; };
  const auto session = Text(kHdf5 + "/Tet_channel_m4_per_hdf5.xml");
  contains(Message({ session }), "Tet_channel_m4_per_hdf5.nekg, which is not there");
  auto mesh = Text(kHdf5 + "/Tet_channel_m4_per_hdf5.nekg");
  mesh.text = mesh.text.substr(0, mesh.text.size() / 2);
  contains(Message({ session, mesh }), "damaged or cut short");
  contains(Message({ Text(kHdf5 + "/nek_tet_varp.fld") }), "GEOMETRY");
}
} // namespace pixelexact::testing
