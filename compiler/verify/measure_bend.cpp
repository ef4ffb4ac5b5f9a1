#include "compiler/verify/measure_bend.h"

#include <algorithm>
#include <limits>
#include <span>

namespace citykiln::verify {
namespace {

constexpr double kLacking = std::numeric_limits<double>::infinity();

struct Compared {
  const map::Cylinder& cylinder;
  Vec3 plane_origin, bent_origin;

  double off_m(std::span<const bake::Float3> plane, std::span<const bake::Float3> bent) const {
    if (bent.size() < plane.size()) return kLacking;
    double farthest_m = 0;
    for (std::size_t i = 0; i < plane.size(); ++i) {
      const Vec3 own = plane_origin + bake::widened(plane[i]);
      const Vec3 back = map::flattened(cylinder, bent_origin + bake::widened(bent[i]), own.y);
      farthest_m = std::max(farthest_m, length(back - own));
    }
    return farthest_m;
  }
};

}  // namespace

double off_cylinder_m(const map::Cylinder& cylinder, const bake::BakedTile& plane, const bake::BakedTile& bent) {
  if (bent.primitives.size() != plane.primitives.size() || bent.instanced.size() != plane.instanced.size())
    return kLacking;
  const Compared compared{cylinder, plane.origin, bent.origin};
  double farthest_m = 0;
  for (std::size_t i = 0; i < plane.primitives.size(); ++i)
    farthest_m = std::max(farthest_m, compared.off_m(plane.primitives[i].positions, bent.primitives[i].positions));
  for (std::size_t i = 0; i < plane.instanced.size(); ++i)
    farthest_m = std::max(farthest_m, compared.off_m(plane.instanced[i].translations, bent.instanced[i].translations));
  return farthest_m;
}

}  // namespace citykiln::verify
