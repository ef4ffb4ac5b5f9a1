// A cache of normals of the graded terrain (the terrain after roads and water have cut into it). A normal needs four
// height samples, and layers and levels of a cell share most vertices.
#pragma once

#include <array>
#include <unordered_map>

#include "compiler/geometry/arrangement.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

/// The cache. Refers to the graded terrain, which must outlive it. Grows with the number of different places. Not
/// thread-safe: at() adds to it.
class GradedNormals {
 public:
  explicit GradedNormals(const GradedTerrain& graded) : graded_(graded) {}

  /// Returns the unit normal of one height layer at p, as normals_at() gives it, bit for bit. O(1) for places sampled
  /// before.
  Vec3 at(GridPoint p, HeightLayer layer) {
    const auto [found, is_new] = normals_.try_emplace(p);
    if (is_new) found->second = normals_at(graded_, plane_point(p));
    return found->second[static_cast<std::size_t>(layer)];
  }

  const GradedTerrain& graded() const { return graded_; }

 private:
  struct PlaceHash {
    std::size_t operator()(GridPoint p) const {
      return hash_of_place(static_cast<std::uint64_t>(p.x), static_cast<std::uint64_t>(p.y));
    }
  };
  const GradedTerrain& graded_;
  std::unordered_map<GridPoint, std::array<Vec3, kHeightLayers>, PlaceHash> normals_;
};

}  // namespace citykiln::ground
