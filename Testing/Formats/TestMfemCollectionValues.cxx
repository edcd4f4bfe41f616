// SPDX-License-Identifier: BSD-3-Clause
#include "MfemElements.h"

#include <gtest/gtest.h>

#include <cmath>

// Values that MFEM 4.9's own element classes give (CalcShape, CalcVShape).
namespace pixelexact::mfem
{
namespace
{
/// The sum of the functions, number i divided by i + 1, at a point of the unit element.
struct Expected
{
  const char* collection;
  Geometry solid;
  std::array<double, 3> value;
};

Point PlaceOf(Geometry solid)
{
  switch (solid)
  {
    case Geometry::Tetrahedron:
      return { 0.06426L, 0.2958L, 0.49L };
    case Geometry::Cube:
      return { 0.3L, 0.58L, 0.49L };
    case Geometry::Prism:
      return { 0.126L, 0.58L, 0.49L };
    default:
      return { 0.153L, 0.2958L, 0.49L };
  }
}

// clang-format off
const Expected kExpected[] = {
  { "H1_3D_P2", Geometry::Tetrahedron, { -0.014960147679999911, 0, 0 } },
  { "H1_3D_P2", Geometry::Cube, { 0.036867248176439618, 0, 0 } },
  { "H1_3D_P2", Geometry::Prism, { 0.053793197475058299, 0, 0 } },
  { "H1_3D_P2", Geometry::Pyramid, { 0.045868788044755242, 0, 0 } },
  { "H1_3D_P5", Geometry::Tetrahedron, { 0.041797948840393284, 0, 0 } },
  { "H1_3D_P5", Geometry::Cube, { 0.0061348723099008658, 0, 0 } },
  { "H1_3D_P5", Geometry::Prism, { 0.0075632490602496206, 0, 0 } },
  { "H1_3D_P5", Geometry::Pyramid, { 0.026178683500206232, 0, 0 } },
  { "H1Pos_3D_P4", Geometry::Tetrahedron, { 0.062929226395825488, 0, 0 } },
  { "H1Pos_3D_P4", Geometry::Cube, { 0.013890462148752102, 0, 0 } },
  { "H1Pos_3D_P4", Geometry::Prism, { 0.025873769527019558, 0, 0 } },
  { "H1Pos_3D_P4", Geometry::Pyramid, { 0.041114242941497424, 0, 0 } },
  { "H1@U_3D_P3", Geometry::Tetrahedron, { 0.10561368753909785, 0, 0 } },
  { "H1@U_3D_P3", Geometry::Cube, { 0.015656265721561299, 0, 0 } },
  { "H1@U_3D_P3", Geometry::Prism, { 0.021018325610144096, 0, 0 } },
  { "H1@U_3D_P3", Geometry::Pyramid, { 0.019322279527995291, 0, 0 } },
  { "H1@c_3D_P4", Geometry::Tetrahedron, { -0.0062539648055100379, 0, 0 } },
  { "H1@c_3D_P4", Geometry::Cube, { 0.0089476610293032881, 0, 0 } },
  { "H1@c_3D_P4", Geometry::Prism, { 0.014130156358446343, 0, 0 } },
  { "H1@c_3D_P4", Geometry::Pyramid, { 0.017604904492628859, 0, 0 } },
  { "H1_3D_P4_Pyr0", Geometry::Tetrahedron, { -0.01148849134823539, 0, 0 } },
  { "H1_3D_P4_Pyr0", Geometry::Cube, { 0.0089555690034275291, 0, 0 } },
  { "H1_3D_P4_Pyr0", Geometry::Prism, { 0.014226388728158217, 0, 0 } },
  { "H1_3D_P4_Pyr0", Geometry::Pyramid, { 0.042204410165930031, 0, 0 } },
  { "L2_3D_P3", Geometry::Tetrahedron, { 0.10696801883670673, 0, 0 } },
  { "L2_3D_P3", Geometry::Cube, { 0.027930839797757887, 0, 0 } },
  { "L2_3D_P3", Geometry::Prism, { 0.040510747626000231, 0, 0 } },
  { "L2_3D_P3", Geometry::Pyramid, { 0.027930839797757786, 0, 0 } },
  { "L2_T1_3D_P3", Geometry::Tetrahedron, { 0.11570481861647916, 0, 0 } },
  { "L2_T1_3D_P3", Geometry::Cube, { 0.026740682301918558, 0, 0 } },
  { "L2_T1_3D_P3", Geometry::Prism, { 0.039433941622693425, 0, 0 } },
  { "L2_T1_3D_P3", Geometry::Pyramid, { 0.025903136906797283, 0, 0 } },
  { "L2_T2_3D_P3", Geometry::Tetrahedron, { 0.075900568449491224, 0, 0 } },
  { "L2_T2_3D_P3", Geometry::Cube, { 0.04767609118449543, 0, 0 } },
  { "L2_T2_3D_P3", Geometry::Prism, { 0.062195372704715111, 0, 0 } },
  { "L2_T2_3D_P3", Geometry::Pyramid, { 0.056492237648029603, 0, 0 } },
  { "L2_T3_3D_P2", Geometry::Tetrahedron, { 0.20356100250158682, 0, 0 } },
  { "L2_T3_3D_P2", Geometry::Cube, { 0.072524967396274426, 0, 0 } },
  { "L2_T3_3D_P2", Geometry::Prism, { 0.086084804399992138, 0, 0 } },
  { "L2_T3_3D_P2", Geometry::Pyramid, { 0.072524967396274675, 0, 0 } },
  { "L2_T5_3D_P2", Geometry::Tetrahedron, { 0.079990359136508205, 0, 0 } },
  { "L2_T5_3D_P2", Geometry::Cube, { 0.07250751456888635, 0, 0 } },
  { "L2_T5_3D_P2", Geometry::Prism, { 0.089252784208084135, 0, 0 } },
  { "L2_T5_3D_P2", Geometry::Pyramid, { 0.072507514568886516, 0, 0 } },
  { "L2Int_3D_P2", Geometry::Tetrahedron, { 0.057913710627397939, 0, 0 } },
  { "L2Int_3D_P2", Geometry::Cube, { 0.072439565950022683, 0, 0 } },
  { "L2Int_3D_P2", Geometry::Prism, { 0.091159848024820106, 0, 0 } },
  { "L2Int_3D_P2", Geometry::Pyramid, { 0.072439565950022308, 0, 0 } },
  { "L2_3D_P3_Pyr0", Geometry::Tetrahedron, { 0.10696801883670673, 0, 0 } },
  { "L2_3D_P3_Pyr0", Geometry::Cube, { 0.027930839797757887, 0, 0 } },
  { "L2_3D_P3_Pyr0", Geometry::Prism, { 0.040510747626000231, 0, 0 } },
  { "L2_3D_P3_Pyr0", Geometry::Pyramid, { 0.070506727265403218, 0, 0 } },
  { "Linear", Geometry::Tetrahedron, { 0.40316999999999997, 0, 0 } },
  { "Linear", Geometry::Cube, { 0.33956450000000005, 0, 0 } },
  { "Linear", Geometry::Prism, { 0.37639966666666674, 0, 0 } },
  { "Linear", Geometry::Pyramid, { 0.36141499999999993, 0, 0 } },
  { "Quadratic", Geometry::Tetrahedron, { -0.014960147680000035, 0, 0 } },
  { "Quadratic", Geometry::Cube, { 0.036867248176439618, 0, 0 } },
  { "Quadratic", Geometry::Prism, { 0.053793197475058299, 0, 0 } },
  { "Cubic", Geometry::Tetrahedron, { 0.1056136875390981, 0, 0 } },
  { "Cubic", Geometry::Cube, { 0.01538080479543575, 0, 0 } },
  { "Cubic", Geometry::Prism, { 0.021018325610144096, 0, 0 } },
  { "LinearDiscont3D", Geometry::Tetrahedron, { 0.40316999999999997, 0, 0 } },
  { "LinearDiscont3D", Geometry::Cube, { 0.33956450000000005, 0, 0 } },
  { "LinearDiscont3D", Geometry::Prism, { 0.37639966666666674, 0, 0 } },
  { "LinearDiscont3D", Geometry::Pyramid, { 0.36141499999999993, 0, 0 } },
  { "QuadraticDiscont3D", Geometry::Tetrahedron, { -0.014960147680000035, 0, 0 } },
  { "QuadraticDiscont3D", Geometry::Cube, { 0.036867248176439618, 0, 0 } },
  { "ND_3D_P1", Geometry::Tetrahedron, { 0.35348333333333326, 0.38486166666666666, 0.48762533333333336 } },
  { "ND_3D_P1", Geometry::Cube, { 0.39456000000000002, 0.233125, 0.094918181818181818 } },
  { "ND_3D_P1", Geometry::Prism, { -0.085056666666666628, -0.095783666666666684, 0.12219444444444444 } },
  { "ND_3D_P1", Geometry::Pyramid, { 0.314585, 0.19497500000000004, 0.36286814285714292 } },
  { "ND_3D_P2", Geometry::Tetrahedron, { -0.19717625757853266, -0.093624342284765197, -0.045218923810468319 } },
  { "ND_3D_P2", Geometry::Cube, { 0.014799218933559118, 0.0053994884825265179, 0.018391214044152341 } },
  { "ND_3D_P2", Geometry::Prism, { -0.0015435317910600325, -0.0066599331964244946, 0.026332983504633312 } },
  { "ND_3D_P3", Geometry::Tetrahedron, { 0.194199009623924, 0.08034980302329485, 0.071541838373764863 } },
  { "ND_3D_P3", Geometry::Cube, { 0.019738936567574292, 0.013428136994928005, 0.0055766482188912021 } },
  { "ND_3D_P3", Geometry::Prism, { 0.022200736883715429, 0.012102358452987249, 0.011618307153167719 } },
  { "ND@Uo_3D_P2", Geometry::Tetrahedron, { -0.19717625757853266, -0.093624342284765197, -0.045218923810468319 } },
  { "ND@Uo_3D_P2", Geometry::Cube, { 0.014803942934330879, 0.0053924917281811795, 0.018392053142617347 } },
  { "ND@Uo_3D_P2", Geometry::Prism, { -0.0015435317910600325, -0.0066599331964244946, 0.026332983504633312 } },
  { "ND@Gi_3D_P3", Geometry::Tetrahedron, { 0.194199009623924, 0.08034980302329485, 0.071541838373764863 } },
  { "ND@Gi_3D_P3", Geometry::Cube, { 0.052422906529113668, 0.028387690056384043, 0.011416480104565351 } },
  { "ND@Gi_3D_P3", Geometry::Prism, { 0.022200736883715429, 0.012102358452987249, 0.011618307153167719 } },
  { "ND_3D_P2", Geometry::Pyramid, { 0.030271465368750736, 0.0077810958938535494, 0.03541658746136632 } },
  { "ND_3D_P3", Geometry::Pyramid, { 0.030856520030073963, 0.024060457590627166, 0.028891092182632097 } },
  { "ND_3D_P4", Geometry::Pyramid, { 0.013605368627647784, 0.011013373917288957, 0.015414638356503085 } },
  { "RT_3D_P0", Geometry::Tetrahedron, { -0.36612500000000003, 0.28291666666666682, 0.77083333333333326 } },
  { "RT_3D_P0", Geometry::Cube, { -0.039999999999999966, -0.06500000000000003, -0.42833333333333334 } },
  { "RT_3D_P0", Geometry::Prism, { -0.1013, 0.12099999999999997, -0.26500000000000001 } },
  { "RT_3D_P0", Geometry::Pyramid, { 0.018675000000000053, 0.048438333333333312, -0.19558333333333333 } },
  { "RT_3D_P1", Geometry::Tetrahedron, { -0.15244218737698584, -0.031492580020240052, -0.012295734812423048 } },
  { "RT_3D_P1", Geometry::Cube, { 0.0048526430602734757, 0.050009251625060355, 0.0214256557086023 } },
  { "RT_3D_P1", Geometry::Prism, { -0.059721504061706947, -0.013295571743132792, 0.032329741252733545 } },
  { "RT_3D_P2", Geometry::Tetrahedron, { -0.05771835273976765, 0.010490732800340999, 0.023322936677455764 } },
  { "RT_3D_P2", Geometry::Cube, { -0.014649077876787462, 0.0080482776008925748, 0.033652820979689767 } },
  { "RT_3D_P2", Geometry::Prism, { -0.026719906958303213, -0.031050495268258288, 0.055007353742075354 } },
  { "RT@Uo_3D_P2", Geometry::Tetrahedron, { -0.05771835273976765, 0.010490732800340999, 0.023322936677455764 } },
  { "RT@Uo_3D_P2", Geometry::Cube, { -0.018125681192202377, 0.0075892442860821998, 0.017641195038959872 } },
  { "RT@Uo_3D_P2", Geometry::Prism, { -0.026719906958303213, -0.031050495268258288, 0.055007353742075354 } },
  { "RT@Gi_3D_P2", Geometry::Tetrahedron, { -0.05771835273976765, 0.010490732800340999, 0.023322936677455764 } },
  { "RT@Gi_3D_P2", Geometry::Cube, { -0.063093559629832319, 0.041921411815078281, 0.20259142794220214 } },
  { "RT@Gi_3D_P2", Geometry::Prism, { -0.026719906958303213, -0.031050495268258288, 0.055007353742075354 } },
  { "RT_3D_P1", Geometry::Pyramid, { -0.0075073602111355329, 0.032659395156812557, 0.029084024825516079 } },
  { "RT_3D_P2", Geometry::Pyramid, { -0.012447666005521722, -0.0078024253071753476, 0.060617379894069602 } },
  { "RT_3D_P3", Geometry::Pyramid, { 0.0081848746684382977, 0.00067337276422323167, 0.0075927835770646743 } },
  { "ND1_3D", Geometry::Tetrahedron, { 0.35348333333333326, 0.38486166666666666, 0.48762533333333336 } },
  { "ND1_3D", Geometry::Cube, { 0.39456000000000002, 0.233125, 0.094918181818181818 } },
  { "ND1_3D", Geometry::Prism, { -0.085056666666666628, -0.095783666666666656, 0.12219444444444445 } },
  { "ND1_3D", Geometry::Pyramid, { 0.31458499999999995, 0.19497500000000004, 0.36286814285714286 } },
  { "RT0_3D", Geometry::Tetrahedron, { -0.73225000000000007, 0.5658333333333333, 1.5416666666666665 } },
  { "RT0_3D", Geometry::Cube, { -0.039999999999999966, -0.06500000000000003, -0.42833333333333334 } },
  { "RT0_3D", Geometry::Prism, { -0.1013, 0.12099999999999997, -0.53000000000000003 } },
  { "RT0_3D", Geometry::Pyramid, { -0.11564999999999998, -0.19892333333333317, 0.11883333333333332 } },
  { "RT1_3D", Geometry::Cube, { 0.0044194395897051049, 0.051288165670565967, 0.0205275037022398 } },
};
// clang-format on

/// MFEM inverts its matrices in double precision.
constexpr double kTolerance = 2e-14;
} // namespace

TEST(MfemCollectionValues, AreThoseOfMfemsElements)
{
  for (const Expected& expected : kExpected)
  {
    const auto collection = Collection::Parse(expected.collection);
    const auto& basis = collection.Basis(expected.solid);
    std::vector<double> source(basis.sources);
    for (std::size_t i = 0; i < source.size(); ++i)
    {
      source[i] = 1.0 / static_cast<double>(i + 1);
    }
    const Point x = PlaceOf(expected.solid);
    // MFEM divides densities by the Jacobian of its own unit element, an eighth of ours.
    const long double scale = collection.GetMapping() == Mapping::Density ? 8 : 1;
    const Point value = basis.IsVector()
      ? UnitVector(collection, expected.solid, source, x)
      : Point{ scale * Value(basis.parts[0], expected.solid, source, x), 0, 0 };
    for (int d = 0; d < 3; ++d)
    {
      EXPECT_NEAR(static_cast<double>(value[d]), expected.value[d], kTolerance)
        << expected.collection << " on " << static_cast<int>(expected.solid);
    }
  }
}
} // namespace pixelexact::mfem
