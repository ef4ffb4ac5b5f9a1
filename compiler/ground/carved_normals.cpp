#include "compiler/ground/carved_normals.h"

namespace citykiln::ground {

// Knuth's multiplicative hashing: the odd numbers spread neighbours over all bits.
std::size_t CarvedNormals::KeyHash::operator()(const Key& key) const {
  const std::uint64_t mixed = static_cast<std::uint64_t>(key.place.x) * 0x9e3779b97f4a7c15u +
                              static_cast<std::uint64_t>(key.place.y) * 0xc2b2ae3d27d4eb4fu +
                              static_cast<std::uint64_t>(key.layer);
  return static_cast<std::size_t>(mixed ^ mixed >> 29);
}

Vec3 CarvedNormals::at(GridPoint p, HeightLayer layer) {
  const auto [found, is_new] = known_.try_emplace({p, layer});
  if (is_new) found->second = normal_at(carving_, plane_point(p), layer);
  return found->second;
}

}  // namespace citykiln::ground
