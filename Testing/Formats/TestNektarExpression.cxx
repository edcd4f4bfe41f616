// SPDX-License-Identifier: BSD-3-Clause
#include "NektarTexts.h"

#include "Formats/Nektar/Files/Expression.h"

#include <cmath>
#include <numbers>

namespace pixelexact::testing
{
namespace
{
constexpr double kPi = std::numbers::pi;
} // namespace

TEST(NektarExpression, ScalesAreExpressions)
{
  const SolverModel model = ReadSession(
    Session(Placed("XSCALE=\"2*PI\" YSCALE=\"1/(2*PI)\" ZSCALE=\" 1e-1 \" XMOVE=\"-2^2\" "
                   "ZMOVE=\"sqrt(2)\"")));
  const Vec3 corner = Corner(model);
  EXPECT_NEAR(corner.x, 2 * kPi - 4, 1e-15 * 8);
  EXPECT_NEAR(corner.y, 1 / (2 * kPi), 1e-16);
  EXPECT_NEAR(corner.z, 0.1 + std::sqrt(2.0), 1e-15);
}

TEST(NektarExpression, ExpressionsUseTheSessionsParameters)
{
  const std::string conditions =
    "<NEKTAR><CONDITIONS><PARAMETERS><P> Half = 1.5 </P><!-- between --><P>Lx = 2*Half*PI</P>"
    "<P> Re = awgn(1) </P></PARAMETERS></CONDITIONS></NEKTAR>";
  const std::string mesh = Session(Placed("XSCALE=\"Lx\""));
  const SolverModel model = nektar::Read({ { "mesh.xml", mesh }, { "run.xml", conditions } }, {});
  EXPECT_NEAR(Corner(model).x, 3 * kPi, 2e-15);
  ExpectRefusal({ { "mesh.xml", mesh } }, { "mesh.xml", "XSCALE", "'Lx'" });
  ExpectRefusal({ { "mesh.xml", Session(Placed("XSCALE=\"Re\"")) }, { "run.xml", conditions } },
    { "XSCALE", "'Re'" });
}

TEST(NektarExpression, ExpressionsFollowNektarsRules)
{
  const auto value = [](std::string_view text)
  { return nektar::Evaluate(text, [](std::string_view) { return std::nullopt; }); };
  // Values computed by hand from the grammar of Nektar++'s interpreter; the first three are its own
  // tests.
  EXPECT_EQ(value("-2"), -2);
  EXPECT_EQ(value("5*(-(2^2)^4)"), -1280);
  EXPECT_EQ(value("2^2^4"), 65536);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("3*-2^2"), 12);
  EXPECT_EQ(value("2^-2^2"), 16);
  EXPECT_EQ(value("1--2"), 3);
  EXPECT_EQ(value("8-4-2"), 2);
  EXPECT_EQ(value("8/4/2"), 1);
  EXPECT_EQ(value("-7 % 4 * 2"), -6);
  EXPECT_EQ(value("1 + 2 <= 3"), 1);
  EXPECT_EQ(value("(2 > 3) == 0"), 1);
  EXPECT_EQ(value("+2 + .5 + 5. + 1E1"), 17.5);
  EXPECT_EQ(value("max(1, min(7, 3)) + abs(-2) + sign(-5)"), 4);
  EXPECT_NEAR(value("ang(0, 2) + atan2(1, 0)"), kPi, 1e-15);
  EXPECT_NEAR(value("rad(3, 4) + fmod(5.2, 3.2)"), 7, 1e-15);
  EXPECT_NEAR(value("PI_2 * E ^ 2 / SQRT1_2"), kPi / 2 * std::exp(2.0) * std::sqrt(2.0), 1e-13);
}

TEST(NektarExpression, ExpressionsThatAreNoneAreRefused)
{
  const auto refuse = [](const std::string& text, const std::string& part)
  {
    const std::string escaped = text == "1<" ? "1&lt;" : text;
    ExpectRefusal(
      { { "a.xml", Session(Placed("YMOVE=\"" + escaped + "\"")) } }, { "a.xml", "YMOVE", part });
  };
  for (const char* text : { "", "1 2", "2PI", "1e", "2*-PI", "+PI", "(1", "1)", "1<", "1,2", "()",
         "sin()", "sin(1", "1 && 1", "0x10", "1;2", "nan" })
  {
    refuse(text, "no expression");
  }
  refuse("twice(1)", "'twice' of 1 argument");
  refuse("atan2(1)", "'atan2' of 1 argument");
  refuse("awgn(1)", "awgn");
  refuse("x", "'x'");
  refuse("1/0", "not finite");
  refuse("1e999", "range");
  refuse(std::string(300, '1'), "256");
  refuse(std::string(100, '(') + "1" + std::string(100, ')'), "32");
}
} // namespace pixelexact::testing
