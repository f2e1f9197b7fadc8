#include <planetree/shape/cylinder.hpp>

namespace planetree {
namespace {

template <class T>
[[nodiscard]] Cone<T> asCone(const Cylinder<T>& cylinder) noexcept {
  return {cylinder.base, cylinder.axis, cylinder.radius, cylinder.radius, cylinder.capped};
}

}  // namespace

template <std::floating_point T>
Box3 Cylinder<T>::bounds() const noexcept {
  return asCone(*this).bounds();
}

template <std::floating_point T>
std::optional<Hit<T>> Cylinder<T>::intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  return asCone(*this).intersect(ray, tMin, tMax);
}

template struct Cylinder<float>;
template struct Cylinder<double>;

}  // namespace planetree
