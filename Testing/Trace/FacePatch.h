// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedCheck.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

// A face of an element as a polynomial of two parameters, made in 113 bits from the element's
// values alone, and all of its intersections with a ray.
namespace pixelexact::testing
{
struct PatchPoint
{
  Vec3 position;
  double u = 0.0;
  double v = 0.0;
  double margin = 0.0; ///< from the face's edges, in its parameters; negative beyond them
  double sine = 0.0;   ///< of the angle between ray and face
  double alone = 0.0;  ///< distance in the parameters from the next intersection
};

class FacePatch
{
public:
  /// `cells`: along each parameter, from which Newton's iteration begins where a ray comes near.
  FacePatch(const Mesh& mesh, int element, int face, int cells = 12)
    : face_(FacesOf(mesh.ShapeOf(element))[static_cast<std::size_t>(face)])
    , shape_(mesh.ShapeOf(element))
    , Cells(cells)
  {
    const Space& space = mesh.map.SpaceOf(element);
    Order = std::max({ space.order[0], space.order[1], space.order[2] });
    const auto e = static_cast<std::size_t>(element);
    const auto n = static_cast<std::size_t>(Order + 1);
    for (int i = 0; i <= Order; ++i)
    {
      // Dyadic, so that nothing is rounded before 113 bits begin.
      const double node = Order == 0 ? 0.0 : -std::cos(3.14159265358979 * i / Order);
      Nodes.push_back(std::round(node * 0x1p20) * 0x1p-20);
    }
    Grid<Quad>& grid = std::get<Grid<Quad>>(Grids);
    Grid<long double>& rounded = std::get<Grid<long double>>(Grids);
    grid.weights.assign(n, Quad(1));
    for (std::size_t i = 0; i < n; ++i)
    {
      for (std::size_t j = 0; j < n; ++j)
      {
        Quad& weight = grid.weights[i];
        weight = i == j ? weight : weight / (Quad(Nodes[i]) - Quad(Nodes[j]));
      }
      rounded.weights.push_back(static_cast<long double>(grid.weights[i].v));
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      for (std::size_t j = 0; j < n; ++j)
      {
        const auto phi = EvaluateQuad(mesh.map, element, XiQuad(Quad(Nodes[i]), Quad(Nodes[j])));
        QuadVec3 x;
        for (std::size_t d = 0; d < 3; ++d)
        {
          x[d] = Quad(mesh.centre[3 * e + d]) + Quad(mesh.size[e]) * phi[d].value;
        }
        grid.points.push_back(x);
        rounded.points.push_back({ static_cast<long double>(x[0].v),
          static_cast<long double>(x[1].v), static_cast<long double>(x[2].v) });
      }
    }
    for (int i = 0; i < Cells; ++i)
    {
      for (int j = 0; j < Cells; ++j)
      {
        Ball ball;
        ball.u = (2.0 * i + 1.0) / Cells - 1.0;
        ball.v = (2.0 * j + 1.0) / Cells - 1.0;
        ball.centre = PointAt(ball.u, ball.v);
        for (const double a : { -1.0, 0.0, 1.0 })
        {
          for (const double b : { -1.0, 0.0, 1.0 })
          {
            ball.radius = std::max(ball.radius,
              glm::length(PointAt(ball.u + a / Cells, ball.v + b / Cells) - ball.centre));
          }
        }
        ball.radius *= 1.5;
        Balls.push_back(ball);
      }
    }
  }

  [[nodiscard]] Vec3 PointAt(double u, double v) const { return ToVec(At(Quad(u), Quad(v)).x); }
  [[nodiscard]] Vec3 NormalAt(double u, double v) const
  {
    const Jet<Quad> jet = At(Quad(u), Quad(v));
    return glm::normalize(glm::cross(ToVec(jet.byU), ToVec(jet.byV)));
  }
  /// The distance of a xi on the face from its edges, in the parameters.
  [[nodiscard]] double MarginOf(const Vec3& xi) const
  {
    const Vec3 eta = ReferenceToTensorOf(xi);
    double margin = 2.0;
    for (const int d : Free())
    {
      margin = std::min(margin, 1.0 - std::fabs(eta[d]));
    }
    return margin;
  }

  /// The sine of the angle between a ray and the face at a xi on it.
  [[nodiscard]] double SineAt(const Vec3& xi, const Ray& ray) const
  {
    const Vec3 eta = ReferenceToTensorOf(xi);
    return std::fabs(glm::dot(NormalAt(eta[Free()[0]], eta[Free()[1]]), ray.direction));
  }

  /// All intersections with the line of a ray, also those just outside of the edges. Newton's
  /// iteration also starts at the xi in `also`; only proven results count.
  [[nodiscard]] std::vector<PatchPoint> Meet(const Ray& ray, const std::vector<Vec3>& also) const
  {
    std::vector<PatchPoint> found;
    for (const Vec3& xi : also)
    {
      const Vec3 eta = ReferenceToTensorOf(xi);
      Search(ray, eta[Free()[0]], eta[Free()[1]], found);
    }
    for (const Ball& ball : Balls)
    {
      const Vec3 to = ball.centre - ray.origin;
      const Vec3 off = to - glm::dot(to, ray.direction) * ray.direction;
      if (glm::length(off) <= ball.radius)
      {
        // Two roots that are close to each other attract the iteration to either.
        const double aside = 0.8 / Cells;
        for (const double a : { -aside, aside })
        {
          Search(ray, ball.u + a, ball.v + a, found);
          Search(ray, ball.u + a, ball.v - a, found);
        }
      }
    }
    for (PatchPoint& one : found)
    {
      one.alone = 10.0;
      for (const PatchPoint& other : found)
      {
        if (&other != &one)
        {
          one.alone =
            std::min(one.alone, std::max(std::fabs(one.u - other.u), std::fabs(one.v - other.v)));
        }
      }
    }
    return found;
  }

private:
  /// The nodes' barycentric weights and points.
  template <class T>
  struct Grid
  {
    std::vector<T> weights;
    std::vector<std::array<T, 3>> points;
  };
  template <class T>
  struct Jet
  {
    std::array<T, 3> x{};
    std::array<T, 3> byU{};
    std::array<T, 3> byV{};
  };
  struct Ball
  {
    double u = 0.0;
    double v = 0.0;
    Vec3 centre{ 0.0 };
    double radius = 0.0;
  };

  [[nodiscard]] std::array<int, 2> Free() const
  {
    return { face_.direction == 0 ? 1 : 0, face_.direction == 2 ? 1 : 2 };
  }
  [[nodiscard]] QuadVec3 XiQuad(const Quad& u, const Quad& v) const
  {
    QuadVec3 eta;
    eta[static_cast<std::size_t>(face_.direction)] = Quad(face_.upper ? 1 : -1);
    eta[static_cast<std::size_t>(Free()[0])] = u;
    eta[static_cast<std::size_t>(Free()[1])] = v;
    return ToXi(shape_, eta);
  }
  [[nodiscard]] Vec3 ReferenceToTensorOf(const Vec3& xi) const
  {
    const auto open = [](double x, double narrow)
    { return narrow > 0.0 ? (1.0 + x) / narrow - 1.0 : 0.0; };
    const double narrow = 0.5 * (1.0 - xi.z);
    switch (shape_)
    {
      case Shape::Hexahedron:
        return xi;
      case Shape::Prism:
        return { open(xi.x, narrow), xi.y, xi.z };
      case Shape::Tetrahedron:
        return { open(xi.x, 0.5 * (-xi.y - xi.z)), open(xi.y, narrow), xi.z };
      default:
        return { open(xi.x, narrow), open(xi.y, narrow), xi.z };
    }
  }
  static Vec3 ToVec(const QuadVec3& x)
  {
    return { static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2]) };
  }

  /// Lagrange's polynomials of the nodes and their derivatives.
  template <class T>
  void Basis(const T& u, std::vector<T>& value, std::vector<T>& slope) const
  {
    const std::size_t n = Nodes.size();
    value.assign(n, T(0));
    slope.assign(n, T(0));
    for (std::size_t i = 0; i < n; ++i)
    {
      T product = std::get<Grid<T>>(Grids).weights[i];
      T derivative(0);
      for (std::size_t j = 0; j < n; ++j)
      {
        if (j != i)
        {
          const T factor = u - T(Nodes[j]);
          derivative = derivative * factor + product;
          product = product * factor;
        }
      }
      value[i] = product;
      slope[i] = derivative;
    }
  }
  template <class T>
  [[nodiscard]] Jet<T> At(const T& u, const T& v) const
  {
    std::vector<T> a;
    std::vector<T> da;
    std::vector<T> b;
    std::vector<T> db;
    Basis(u, a, da);
    Basis(v, b, db);
    Jet<T> jet;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      std::array<T, 3> x{};
      std::array<T, 3> by{};
      for (std::size_t j = 0; j < b.size(); ++j)
      {
        const std::array<T, 3>& point = std::get<Grid<T>>(Grids).points[i * b.size() + j];
        for (std::size_t d = 0; d < 3; ++d)
        {
          x[d] = x[d] + b[j] * point[d];
          by[d] = by[d] + db[j] * point[d];
        }
      }
      for (std::size_t d = 0; d < 3; ++d)
      {
        jet.x[d] = jet.x[d] + a[i] * x[d];
        jet.byU[d] = jet.byU[d] + da[i] * x[d];
        jet.byV[d] = jet.byV[d] + a[i] * by[d];
      }
    }
    return jet;
  }
  /// Newton's iteration for the two coordinates across the ray, until a step is this small.
  template <class T>
  [[nodiscard]] bool Arrives(const Ray& ray, T& u, T& v, double small) const
  {
    int k = 0;
    for (int d = 1; d < 3; ++d)
    {
      k = std::fabs(ray.direction[d]) > std::fabs(ray.direction[k]) ? d : k;
    }
    const auto along = static_cast<std::size_t>(k);
    const auto isBelow = [](const T& x, double limit) { return x < T(limit) && T(-limit) < x; };
    for (int step = 0; step < 25; ++step)
    {
      const Jet<T> jet = At(u, v);
      T g[2];
      T m[2][2];
      for (std::size_t a = 0; a < 2; ++a)
      {
        const std::size_t c = (along + 1 + a) % 3;
        const T s = T(ray.direction[static_cast<int>(c)]) / T(ray.direction[k]);
        g[a] =
          jet.x[c] - T(ray.origin[static_cast<int>(c)]) - s * (jet.x[along] - T(ray.origin[k]));
        m[a][0] = jet.byU[c] - s * jet.byU[along];
        m[a][1] = jet.byV[c] - s * jet.byV[along];
      }
      const T determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
      const T du = (g[0] * m[1][1] - g[1] * m[0][1]) / determinant;
      const T dv = (g[1] * m[0][0] - g[0] * m[1][0]) / determinant;
      u = u - du;
      v = v - dv;
      if (!isBelow(u, 1.5) || !isBelow(v, 1.5))
      {
        return false;
      }
      if (isBelow(du, small) && isBelow(dv, small))
      {
        return true;
      }
    }
    return false;
  }

  /// Iterates in long double as far as possible, and then in 113 bits.
  void Search(const Ray& ray, double startU, double startV, std::vector<PatchPoint>& found) const
  {
    long double nearU = startU;
    long double nearV = startV;
    if (!Arrives(ray, nearU, nearV, 1e-12) ||
      IsFound(static_cast<double>(nearU), static_cast<double>(nearV), found))
    {
      return;
    }
    Quad u(static_cast<double>(nearU));
    Quad v(static_cast<double>(nearV));
    if (Arrives(ray, u, v, 1e-24))
    {
      Add(ray, static_cast<double>(u), static_cast<double>(v), found);
    }
  }
  static bool IsFound(double u, double v, const std::vector<PatchPoint>& found)
  {
    return std::ranges::any_of(found,
      [&](const PatchPoint& one)
      { return std::fabs(one.u - u) < 1e-13 && std::fabs(one.v - v) < 1e-13; });
  }
  void Add(const Ray& ray, double u, double v, std::vector<PatchPoint>& found) const
  {
    const double margin = 1.0 - std::max(std::fabs(u), std::fabs(v));
    if (margin < -1e-9 || IsFound(u, v, found))
    {
      return;
    }
    const Jet<Quad> jet = At(Quad(u), Quad(v));
    const Vec3 normal = glm::cross(ToVec(jet.byU), ToVec(jet.byV));
    PatchPoint one;
    one.position = ToVec(jet.x);
    one.u = u;
    one.v = v;
    one.margin = margin;
    one.sine = std::fabs(glm::dot(glm::normalize(normal), ray.direction));
    found.push_back(one);
  }

  pixelexact::ShapeFace face_;
  Shape shape_;
  int Cells;
  int Order = 1;
  std::vector<double> Nodes;
  std::tuple<Grid<Quad>, Grid<long double>> Grids;
  std::vector<Ball> Balls;
};
} // namespace pixelexact::testing
