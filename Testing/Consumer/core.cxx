#include "Core/Shape/Shape.h"
#include "Trace/Camera.h"

#include <cstdlib>
#include <iostream>

int main()
{
  using namespace pixelexact;
  const Camera camera(CameraView{}, 2, 2);
  const Ray ray = camera.At(1.0, 1.0);
  const Shape shape = Shape::Pyramid;
  std::cout << Name(shape) << ", a ray along z: " << ray.direction.z << '\n';
  const bool good = Margin(shape, Centre(shape)) > 0.0 && ray.direction.z < -0.999;
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
