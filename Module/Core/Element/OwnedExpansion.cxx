// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/OwnedExpansion.h"

#include <algorithm>
#include <map>
#include <new>

namespace pixelexact
{
namespace
{
/// Allocates at least one number, also where `size` is 0.
std::size_t BytesOf(std::size_t size)
{
  return std::max<std::size_t>(size, 1) * sizeof(double);
}
} // namespace

CoefficientBlock::CoefficientBlock(std::size_t size)
  : Values(static_cast<double*>(std::malloc(BytesOf(size))))
  , Count(size)
{
  if (!Values)
  {
    throw std::bad_alloc();
  }
}

void CoefficientBlock::Shrink(std::size_t size)
{
  auto* const smaller = static_cast<double*>(std::realloc(Values.get(), BytesOf(size)));
  if (smaller == nullptr)
  {
    throw std::bad_alloc();
  }
  (void)Values.release(); // realloc has freed it
  Values.reset(smaller);
  Count = size;
}

double* CoefficientBlock::Release()
{
  Count = 0;
  return Values.release();
}

void OwnedExpansion::Allocate()
{
  offset.clear();
  offset.reserve(spaceOf.size());
  std::size_t size = 0;
  for (std::size_t e = 0; e < spaceOf.size(); ++e)
  {
    offset.push_back(static_cast<std::int64_t>(size));
    size += SizeOf(e);
  }
  coefficients = CoefficientBlock(size);
}

void OwnedExpansion::Allocate(std::span<const Space> spaceOfElement, int numberOfComponents)
{
  components = numberOfComponents;
  spaces.clear();
  spaceOf.clear();
  spaceOf.reserve(spaceOfElement.size());
  std::map<Space, std::int32_t> known;
  for (const Space& space : spaceOfElement)
  {
    const auto [at, isNew] = known.try_emplace(space, static_cast<std::int32_t>(known.size()));
    if (isNew)
    {
      spaces.push_back(space);
    }
    spaceOf.push_back(at->second);
  }
  Allocate();
}
} // namespace pixelexact
