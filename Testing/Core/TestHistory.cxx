// SPDX-License-Identifier: BSD-3-Clause
// An answer depends on the question and the mesh alone: it has the same bytes alone and with
// others, in any order, after any others, from any number of threads and whichever trees were
// dropped.
#include "CurvedMeshes.h"

#include "Core/Location/Owners.h"
#include "Core/Location/Sample.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <ostream>
#include <string>

namespace pixelexact::testing
{
namespace
{
/// The bytes of an answer, one string for each point.
using Answers = std::vector<std::string>;

template <class... T>
std::string Bytes(const T&... parts)
{
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&parts), sizeof(parts)), ...);
  return bytes;
}

/// Elements, a xi next to which they are special, and what they are called.
struct Case
{
  using Special = std::function<Vec3(Random& random)>;

  std::string name;
  Shape shape;
  int order;
  std::vector<MeshBuilder::Map> maps;
  Special special;
};

std::ostream& operator<<(std::ostream& out, const Case& what)
{
  return out << what.name;
}

/// The image of an end of the cube of eta.
Case::Special End(Shape shape, int direction, double end)
{
  return [=](Random& random)
  {
    Vec3 eta(random(), random(), random());
    eta[direction] = end;
    return TensorToReference(shape, eta);
  };
}

MeshBuilder::Map CurvedOfOrder(int order)
{
  return [=](const LongVec3& xi) -> LongVec3
  {
    const auto [a, b, c] = xi;
    return { a + 0.08L * std::pow(b, order), b + 0.08L * std::pow(c, order),
      c + 0.08L * std::pow(a, order) };
  };
}

/// Three sectors of a hexagonal cylinder, each a hexahedron with a face collapsed to the axis.
std::vector<MeshBuilder::Map> Sectors()
{
  const LongVec3 corners[] = { { 1, 0, 0 }, { 0.5L, 0.875L, 0 }, { -0.5L, 0.875L, 0 },
    { -1, 0, 0 } };
  std::vector<MeshBuilder::Map> maps;
  for (std::size_t n = 0; n < 3; ++n)
  {
    const LongVec3 from = corners[n];
    const LongVec3 to = corners[n + 1];
    maps.emplace_back(
      [=](const LongVec3& xi) -> LongVec3
      {
        const long double part = (1 + xi[1]) / 2;
        const auto at = [&](int d)
        { return (1 + xi[0]) / 2 * (from[d] * (1 - part) + to[d] * part); };
        return { at(0), at(1), xi[2] };
      });
  }
  return maps;
}

std::vector<Case> Cases()
{
  std::vector<Case> cases;
  for (const Shape shape : kShapes)
  {
    for (int order = 1; order <= 8; ++order)
    {
      cases.push_back({ std::string(Name(shape)) + "_" + std::to_string(order), shape, order,
        { CurvedOfOrder(order) }, End(shape, order % 3, -1.0) });
    }
  }
  const auto add = [&](const char* name, Shape shape, int order, const MeshBuilder::Map& map,
                     auto special) {
    cases.push_back({ name, shape, order, { map }, special });
  };
  constexpr Shape kHexahedron = Shape::Hexahedron;
  add(
    "hexahedron_face_to_edge", kHexahedron, 2,
    [](const LongVec3& xi) -> LongVec3 {
      return { (1 + xi[0]) / 2, (1 + xi[0]) * xi[1] / 2, xi[2] };
    },
    End(kHexahedron, 0, -1.0));
  add(
    "curved_hexahedron_face_to_edge", kHexahedron, 4,
    [](const LongVec3& xi) -> LongVec3
    {
      const auto [a, b, c] = xi;
      return { (1 + a) / 2 + 0.1L * c * c, (1 + a) * (b + 0.1L * b * b * c) / 2 + 0.1L * c * c * c,
        c + 0.1L * a * a };
    },
    End(kHexahedron, 0, -1.0));
  add(
    "hexahedron_edge_to_point", kHexahedron, 1,
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0], xi[1], xi[2] * (1 - (1 - xi[0]) * (1 - xi[1]) / 4) };
    },
    [](Random& random) { return Vec3(-1.0, -1.0, random()); });
  add(
    "hexahedron_face_to_point", kHexahedron, 2,
    [](const LongVec3& xi) -> LongVec3 {
      return { (1 + xi[0]) * xi[1] / 2, (1 + xi[0]) * xi[2] / 2, xi[0] };
    },
    End(kHexahedron, 0, -1.0));
  add(
    "prism_face_to_edge", Shape::Prism, 2,
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0], xi[1] * (1 + xi[2]) / 2, xi[2] };
    },
    End(Shape::Prism, 2, -1.0));
  add(
    "prism_edge_to_point", Shape::Prism, 2,
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0], xi[1] * (1 - xi[2]) / 2, xi[2] };
    },
    End(Shape::Prism, 2, 1.0));
  add(
    "prism_end_to_edge", Shape::Prism, 2,
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0], xi[1], (1 + xi[2]) * (1 - xi[1]) / 2 };
    },
    End(Shape::Prism, 1, 1.0));
  add(
    "prism_end_to_point", Shape::Prism, 2,
    [](const LongVec3& xi) -> LongVec3 {
      return { (1 + xi[0]) * (1 - xi[1]) / 2, xi[1], (1 + xi[2]) * (1 - xi[1]) / 2 };
    },
    End(Shape::Prism, 1, 1.0));
  add(
    "pyramid_edge_to_point", Shape::Pyramid, 1,
    [](const LongVec3& xi) -> LongVec3
    {
      const auto [a, b, c] = xi;
      return { a, c < 1 ? (1 + a) * (1 + b) / (1 - c) : 0, c };
    },
    End(Shape::Pyramid, 0, -1.0));
  add(
    "pinched_hexahedron", kHexahedron, 3,
    [](const LongVec3& xi) -> LongVec3 {
      return { 0.625L * xi[0] * xi[0] * xi[0] + 0x1p-40L * xi[0], xi[1] + 0.1L * xi[0], xi[2] };
    },
    End(kHexahedron, 0, 0.0));
  cases.push_back(
    { "sectors_about_an_axis", kHexahedron, 2, Sectors(), End(kHexahedron, 0, -1.0) });
  return cases;
}

/// Elements of a case, a field on them, and points.
class History : public ::testing::TestWithParam<Case>
{
protected:
  History()
  {
    const Case& what = GetParam();
    for (const auto& map : what.maps)
    {
      Elements.Add(UniformSpace(what.shape, what.order), map);
      Values.Add(UniformSpace(what.shape, 3),
        [](const LongVec3& xi, long double* u)
        { u[0] = xi[0] + 0.5L * xi[1] * xi[2] + 0.2L * xi[2] * xi[2] * xi[2]; });
    }
    field_ = { "u", Values.View() };
    mesh_ = Elements.View();
  }

  [[nodiscard]] Vec3 Image(const Vec3& xi, Random& random) const
  {
    const auto& maps = GetParam().maps;
    const auto which = static_cast<std::size_t>(random(0.0, static_cast<double>(maps.size())));
    return ToDouble(maps[std::min(which, maps.size() - 1)](ToLong(xi)));
  }

  /// Half of the points are within 1e-16 of a special place, the others near a face, inside, and in
  /// the box.
  [[nodiscard]] std::vector<Vec3> Points(int count, std::uint64_t seed) const
  {
    Random random(seed);
    const Case& what = GetParam();
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
    {
      const int kind = i % 6;
      if (kind == 5)
      {
        points.emplace_back(random(-1.2, 1.2), random(-1.2, 1.2), random(-1.2, 1.2));
        continue;
      }
      const Vec3 xi = kind < 3 ? what.special(random)
        : kind == 3            ? End(what.shape, i % 3, random() < 0.0 ? -1.0 : 1.0)(random)
                               : random.Inside(what.shape);
      const double apart = i % 12 == 0 ? 0.0 : std::pow(10.0, random(-16.0, -1.0));
      const Vec3 direction(random(), random(), random());
      points.push_back(Image(xi, random) + apart * direction);
    }
    return points;
  }

  /// All results of Sample.
  Answers Ask(const Locator& locator, std::span<const Vec3> x) const
  {
    const std::size_t n = x.size();
    std::vector<std::int32_t> element(n);
    std::vector<Vec3> xi(n);
    std::vector<Verdict> verdict(n);
    std::vector<double> residual(n);
    std::vector<double> value(n);
    std::vector<double> gradient(3 * n);
    std::vector<double> lower(n);
    std::vector<double> upper(n);
    Sample(locator, &field_, x, { element, xi, verdict, residual, value, gradient, lower, upper });
    Answers answers;
    for (std::size_t i = 0; i < n; ++i)
    {
      answers.push_back(Bytes(verdict[i], element[i], xi[i], residual[i], value[i], gradient[3 * i],
        gradient[3 * i + 1], gradient[3 * i + 2], lower[i], upper[i]));
    }
    return answers;
  }

  ExpansionBuilder Values{ 1 };
  MeshBuilder Elements;
  Field field_;
  Mesh mesh_;
};

/// All preimages.
Answers AskAll(const Locator& locator, std::span<const Vec3> x)
{
  class Collector final : public PreimageSink
  {
  public:
    explicit Collector(Answers& answers)
      : All(answers)
    {
    }
    void Found(int index, const pixelexact::Preimage& preimage) override
    {
      All[static_cast<std::size_t>(index)] += Bytes(preimage.element, preimage.xi, preimage.onFace);
    }
    void Undecided(int index, int element) override
    {
      All[static_cast<std::size_t>(index)] += Bytes(element);
    }

  private:
    Answers& All;
  };
  Answers answers(x.size());
  Collector collector(answers);
  locator.LocateAll(x, collector);
  return answers;
}

Answers AskOwners(const Locator& locator, std::span<const Vec3> x)
{
  std::vector<Owners> owners(x.size());
  FindOwners(locator, x, owners);
  Answers answers(x.size());
  std::ranges::transform(owners, answers.begin(),
    [](const Owners& each) { return Bytes(each.preimages, each.elements, each.coverage); });
  return answers;
}

void ExpectSame(const Answers& answers, const Answers& wanted, const std::string& how)
{
  ASSERT_EQ(answers.size(), wanted.size());
  const auto [at, other] = std::ranges::mismatch(answers, wanted);
  EXPECT_EQ(at, answers.end()) << how << ", first of point " << at - answers.begin();
}

std::vector<std::size_t> Shuffled(std::size_t count, std::uint64_t seed)
{
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  Random random(seed);
  for (std::size_t i = count; i > 1; --i)
  {
    std::swap(order[i - 1], order[static_cast<std::size_t>(random(0.0, static_cast<double>(i)))]);
  }
  return order;
}

/// Asks for all points in each way that could leave a trace.
template <class Way>
void ExpectOneAnswer(
  const Mesh& mesh, std::span<const Vec3> x, std::span<const Vec3> others, const Way& ask)
{
  const Locator first(mesh);
  const Answers wanted = ask(first, x);
  ExpectSame(ask(first, x), wanted, "again");

  const auto oneByOne = [&](const Locator& locator)
  {
    Answers answers;
    for (const Vec3& point : x)
    {
      answers.push_back(ask(locator, std::span(&point, 1))[0]);
    }
    return answers;
  };
  const Locator second(mesh);
  ExpectSame(oneByOne(second), wanted, "one by one");
  for (std::size_t i = 0; i < x.size(); i += 7)
  {
    const Locator alone(mesh);
    EXPECT_EQ(ask(alone, x.subspan(i, 1))[0], wanted[i]) << "alone, point " << i;
  }

  const Locator used(mesh);
  ask(used, others);
  ExpectSame(ask(used, x), wanted, "after others");

  for (const std::uint64_t seed : { 1U, 2U, 3U })
  {
    const auto order = Shuffled(x.size(), seed);
    std::vector<Vec3> shuffled(x.size());
    std::ranges::transform(order, shuffled.begin(), [&](std::size_t at) { return x[at]; });
    const Locator fresh(mesh);
    const Answers there = ask(fresh, shuffled);
    Answers answers(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      answers[order[i]] = there[i];
    }
    ExpectSame(answers, wanted, "shuffled by seed " + std::to_string(seed));
  }

  Locator forgetful(mesh);
  forgetful.Index().SetTreeLimit(0);
  ExpectSame(ask(forgetful, x), wanted, "trees dropped");
  ExpectSame(oneByOne(forgetful), wanted, "one by one, trees dropped");
}

/// Calls body(i) for i < count on this number of threads, even with fewer processors.
template <class Body>
void OnThreads(int threads, std::size_t count, const Body& body)
{
  const tbb::global_control limit(
    tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute(
    [&] { tbb::parallel_for(std::size_t{ 0 }, count, body, tbb::simple_partitioner()); });
}

/// Threads that grow and drop the same trees, each with chunks of neighbours in the list.
template <class Way>
void ExpectOneAnswerOnThreads(const Mesh& mesh, std::span<const Vec3> x, const Way& ask)
{
  constexpr std::size_t kChunk = 2;
  constexpr int kRepeats = 20;
  const Locator first(mesh);
  const Answers wanted = ask(first, x);
  for (const int threads : { 1, 2, 16 })
  {
    for (int repeat = 0; repeat < (threads == 1 ? 2 : kRepeats); ++repeat)
    {
      Locator locator(mesh);
      locator.Index().SetTreeLimit(repeat % 2 == 0 ? std::size_t{ 256 } << 20U : 0);
      Answers answers(x.size());
      OnThreads(threads, (x.size() + kChunk - 1) / kChunk,
        [&](std::size_t chunk)
        {
          const std::size_t begin = chunk * kChunk;
          const auto some = x.subspan(begin, std::min(kChunk, x.size() - begin));
          std::ranges::copy(
            ask(locator, some), answers.begin() + static_cast<std::ptrdiff_t>(begin));
        });
      ExpectSame(answers, wanted, std::to_string(threads) + " threads");
    }
  }
}
} // namespace

TEST_P(History, LeavesNoTraceInSamples)
{
  const auto ask = [this](const Locator& locator, std::span<const Vec3> x)
  { return Ask(locator, x); };
  ExpectOneAnswer(mesh_, Points(48, 1), Points(24, 2), ask);
}

TEST_P(History, LeavesNoTraceInPreimages)
{
  ExpectOneAnswer(mesh_, Points(24, 3), Points(12, 4), AskAll);
}

TEST_P(History, LeavesNoTraceInOwners)
{
  ExpectOneAnswer(mesh_, Points(12, 11), Points(6, 12), AskOwners);
}

TEST_P(History, ThreadsLeaveNoTrace)
{
  const auto ask = [this](const Locator& locator, std::span<const Vec3> x)
  {
    Answers answers = Ask(locator, x);
    const Answers all = AskAll(locator, x);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      answers[i] += all[i];
    }
    return answers;
  };
  ExpectOneAnswerOnThreads(mesh_, Points(8, 5), ask);
}

INSTANTIATE_TEST_SUITE_P(
  Elements, History, ::testing::ValuesIn(Cases()), [](const auto& one) { return one.param.name; });

/// More points than Sample takes at once, so that it shares them out itself.
TEST(HistoryOfMeshes, ShapesSideBySide)
{
  const CurvedMesh mesh = Blocks(2, kShapes);
  const Mesh view = mesh.View();
  Random random(10);
  std::vector<Vec3> x;
  for (int i = 0; i < 6000; ++i)
  {
    // Half of the points are on or near the planes between blocks.
    LongVec3 u{ random(-1.05, 1.05), random(-1.05, 1.05), random(-1.05, 1.05) };
    if (i % 2 == 0)
    {
      u[i / 2 % 3] = i % 8 == 0 ? 0.0 : std::pow(10.0, random(-16.0, -1.0));
    }
    x.push_back(ToDouble(mesh.Placed()(u)));
  }
  const auto ask = [&](const Locator& locator, std::span<const Vec3> points)
  {
    std::vector<std::int32_t> element(points.size());
    std::vector<Vec3> xi(points.size());
    std::vector<Verdict> verdict(points.size());
    SampleTarget target;
    target.element = element;
    target.xi = xi;
    target.verdict = verdict;
    Sample(locator, nullptr, points, target);
    Answers answers;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      answers.push_back(Bytes(verdict[i], element[i], xi[i]));
    }
    return answers;
  };
  const std::vector<Vec3> others(x.rbegin(), x.rbegin() + 1000);
  ExpectOneAnswer(view, x, others, ask);
  const Locator first(view);
  const Answers wanted = ask(first, x);
  for (const int threads : { 1, 2, 16 })
  {
    for (int repeat = 0; repeat < (threads == 1 ? 2 : 20); ++repeat)
    {
      const Locator locator(view);
      Answers answers;
      OnThreads(threads, 1, [&](std::size_t) { answers = ask(locator, x); });
      ExpectSame(answers, wanted, std::to_string(threads) + " threads");
    }
  }
}
} // namespace pixelexact::testing
