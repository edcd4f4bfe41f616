// SPDX-License-Identifier: BSD-3-Clause
// Functions whose values an observer gives: answers, batches, and who may not ask.
#include "Window.h"

#include "Core/Base/Error.h"
#include "Surfaces/VtkSurface.h"
#include "vtkImplicitCallback.h"

#include "vtkDoubleArray.h"
#include "vtkImplicitBoolean.h"
#include "vtkSphere.h"

#include <cmath>
#include <functional>
#include <thread>
#include <vector>

namespace pixelexact
{
namespace
{
using testing::Contains;
using testing::ErrorObserver;

class Answer : public vtkCommand
{
public:
  static Answer* New() { return new Answer; }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* function = vtkImplicitCallback::SafeDownCast(caller);
    Batches.push_back(function->GetPoints()->GetNumberOfTuples());
    How(function);
  }

  std::function<void(vtkImplicitCallback*)> How;
  std::vector<vtkIdType> Batches;
};

/// x^2 + y^2 + z^2 - 1
void UnitBall(vtkImplicitCallback* function)
{
  for (vtkIdType i = 0; i < function->GetPoints()->GetNumberOfTuples(); ++i)
  {
    const double* x = function->GetPoints()->GetPointer(3 * i);
    function->GetValues()->SetValue(i, x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1.0);
  }
}

class ImplicitCallback : public ::testing::Test
{
protected:
  ImplicitCallback()
  {
    Values->How = UnitBall;
    Function->AddObserver(vtkImplicitCallback::EvaluateEvent, Values);
    Function->AddObserver(vtkCommand::ErrorEvent, Errors);
  }

  static SurfaceSearch Search() { return { { Vec3(-2.0), Vec3(2.0) } }; }

  /// The function's own messages.
  std::string Told()
  {
    Errors->Text.clear();
    EXPECT_TRUE(std::isnan(Function->FunctionValue(0.5, 0.0, 0.0)));
    return Errors->Text;
  }

  vtkNew<vtkImplicitCallback> Function;
  vtkNew<Answer> Values;
  vtkNew<ErrorObserver> Errors;
};

} // namespace

TEST_F(ImplicitCallback, AnswersAsAnyFunction)
{
  EXPECT_EQ(Function->FunctionValue(0.5, 0.0, 0.0), -0.75);
  double gradient[3];
  const double x[3] = { 0.5, -0.25, 1.0 };
  Function->FunctionGradient(x, gradient);
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(gradient[d], 2.0 * x[d], 1e-9);
  }
  Function->SetDifferenceStep(-1.0);
  EXPECT_GT(Function->GetDifferenceStep(), 0.0);
  EXPECT_EQ(Errors->Text, "");
}

TEST_F(ImplicitCallback, RaysAskForAllOfTheirSamplesAtOnce)
{
  const auto surface = ToSurface(Function, Search());
  EXPECT_TRUE(surface->NeedsCallingThread());
  const std::vector<Hit> hits = HitsOf(*surface, { { -3.0, 0.3, 0.2 }, { 1.0, 0.0, 0.0 } });
  ASSERT_EQ(hits.size(), 2U);
  const double half = std::sqrt(1.0 - 0.09 - 0.04);
  EXPECT_NEAR(hits[0].t, 3.0 - half, 1e-13);
  EXPECT_NEAR(hits[1].t, 3.0 + half, 1e-13);
  EXPECT_EQ(hits[0].status, HitStatus::Numeric);
  EXPECT_EQ(Values->Batches.front(), 128);
  EXPECT_LT(Values->Batches.size(), 20U);
  const Vec3 normal = surface->Normal({ hits[0].position });
  EXPECT_LT(glm::length(normal - Vec3(-half, 0.3, 0.2)), 1e-9);
  EXPECT_EQ(Values->Batches.back(), 6);
}

TEST_F(ImplicitCallback, BooleansAskForManyToo)
{
  vtkNew<vtkSphere> other;
  other->SetCenter(0.5, 0.0, 0.0);
  other->SetRadius(1.0);
  vtkNew<vtkImplicitBoolean> lens;
  lens->SetOperationTypeToIntersection();
  lens->AddFunction(other);
  lens->AddFunction(Function);
  const auto surface = ToSurface(lens, Search());
  EXPECT_TRUE(surface->NeedsCallingThread());
  const std::vector<Hit> hits = HitsOf(*surface, { { -3.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } });
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_NEAR(hits[0].t, 2.5, 1e-13);
  EXPECT_NEAR(hits[1].t, 4.0, 1e-13);
  EXPECT_EQ(Values->Batches.front(), 128);
  EXPECT_FALSE(ToSurface(other, Search())->NeedsCallingThread());
}

TEST_F(ImplicitCallback, WhatFailsIsToldToWhoAsked)
{
  Values->How = [](vtkImplicitCallback* function) { function->SetFailure("no more of these"); };
  EXPECT_TRUE(Contains(Told(), "no more of these")) << Errors->Text;
  Errors->Text.clear();
  const auto surface = ToSurface(Function, Search());
  try
  {
    (void)HitsOf(*surface, { { -3.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } });
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_TRUE(Contains(error.what(), "vtkImplicitCallback: no more of these")) << error.what();
  }
  EXPECT_EQ(Errors->Text, "") << "told twice";
  Values->How = [](vtkImplicitCallback* function) { function->GetValues()->SetNumberOfTuples(3); };
  EXPECT_TRUE(Contains(Told(), "3 answers of 1 components for 1 points")) << Errors->Text;
  Values->How = [](vtkImplicitCallback*) {};
  EXPECT_TRUE(Contains(Told(), "its value at (0.5, 0, 0) is nan")) << Errors->Text;
  Values->How = [](vtkImplicitCallback* function) { function->FunctionValue(0.0, 0.0, 0.0); };
  EXPECT_TRUE(Contains(Told(), "its observer asks for its values")) << Errors->Text;
  Function->RemoveAllObservers();
  Function->AddObserver(vtkCommand::ErrorEvent, Errors);
  EXPECT_TRUE(Contains(Told(), "nobody gives its values")) << Errors->Text;
}

TEST_F(ImplicitCallback, OtherThreadsGetNone)
{
  std::string told;
  std::thread([&] { told = Told(); }).join();
  EXPECT_TRUE(Contains(told, "another thread")) << told;
  EXPECT_TRUE(Values->Batches.empty());
}
} // namespace pixelexact
