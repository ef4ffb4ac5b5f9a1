#include "compiler/ground/grading/graded_normals.h"

namespace citykiln::ground {

// Knuth's multiplicative hashing: the odd numbers spread neighbours over all bits.
std::size_t GradedNormals::PlaceHash::operator()(GridPoint place) const {
  const std::uint64_t mixed = static_cast<std::uint64_t>(place.x) * 0x9e3779b97f4a7c15u +
                              static_cast<std::uint64_t>(place.y) * 0xc2b2ae3d27d4eb4fu;
  return static_cast<std::size_t>(mixed ^ mixed >> 29);
}

Vec3 GradedNormals::at(GridPoint p, HeightLayer layer) {
  const auto [found, is_new] = known_.try_emplace(p);
  if (is_new) found->second = normals_at(graded_, plane_point(p));
  return found->second[static_cast<std::size_t>(layer)];
}

}  // namespace citykiln::ground
