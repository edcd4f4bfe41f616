// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/FrameCost.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pixelexact
{
namespace
{
constexpr double kPixels = 1e6;

/// A pass' seconds where elements and pixels cost something.
double PredictSeconds(double elements, double pixels, int step)
{
  return elements + pixels / (static_cast<double>(step) * step);
}
} // namespace

TEST(FrameCost, NothingKnownBeginsCoarse)
{
  const FrameCost cost;
  EXPECT_EQ(cost.First(kPixels, 1e9), ProgressiveFrame::kCoarsest);
}

TEST(FrameCost, TheFinestPassThatIsInTime)
{
  FrameCost cost;
  cost.Learn(kPixels, 1, 1.0, 0.3);
  EXPECT_EQ(cost.First(kPixels, 0.4), 1);
  EXPECT_EQ(cost.First(kPixels / 4.0, 0.1), 1);
  cost.Learn(kPixels, 4, 1.0, 0.02);
  cost.Learn(kPixels, 16, 1.0, 0.01);
  EXPECT_EQ(cost.First(kPixels, 0.4), 1);
  EXPECT_EQ(cost.First(kPixels, 0.1), 4);
  EXPECT_EQ(cost.First(kPixels, 0.015), 16);
  EXPECT_EQ(cost.First(kPixels, 0.0), 16);
}

TEST(FrameCost, AFrameThatWasSlowOnceIsForgotten)
{
  FrameCost cost;
  // A first frame makes what later ones keep.
  cost.Learn(kPixels, 1, 1.0, 30.0);
  EXPECT_EQ(cost.First(kPixels, 0.1), 16);
  // Coarse passes give an upper bound of the cost.
  cost.Learn(kPixels, 16, 1.0, 1e-4);
  EXPECT_EQ(cost.First(kPixels, 0.1), 1);
}

TEST(FrameCost, WhatIsCloserCostsMore)
{
  FrameCost cost;
  cost.Learn(kPixels, 1, 1.0, 0.01);
  EXPECT_EQ(cost.First(kPixels, 0.03), 1);
  // A tenth of it took longer than all of it before.
  cost.Learn(kPixels, 1, 0.1, 0.03);
  EXPECT_EQ(cost.First(kPixels, 0.03), 4);
  cost.Learn(kPixels, 16, 1.0, 0.04);
  EXPECT_EQ(cost.First(kPixels, 0.03), 16);
  EXPECT_EQ(cost.First(kPixels, 0.2), 4);
}

TEST(FrameCost, HoldsWhereElementsOrPixelsCost)
{
  for (const double elements : { 0.0, 0.01, 0.1 })
  {
    for (const double pixels : { 0.001, 0.1, 1.0 })
    {
      FrameCost cost;
      for (const int step : { 1, 4, 16 })
      {
        cost.Learn(kPixels, step, 1.0, PredictSeconds(elements, pixels, step));
      }
      for (const double limit : { 0.005, 0.02, 0.05, 0.5 })
      {
        const int first = cost.First(kPixels, limit);
        EXPECT_TRUE(first == 16 || PredictSeconds(elements, pixels, first) <= limit);
        EXPECT_TRUE(first == 1 || PredictSeconds(elements, pixels, first / 4) > limit);
      }
    }
  }
}
} // namespace pixelexact
