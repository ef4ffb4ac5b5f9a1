// Normals of the graded terrain, each made once: four places are asked for those of one, layers meet there, and levels
// of a cell share most of their vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "compiler/geometry/arrangement.h"
#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::ground {

/// Of one carving, which must outlive it. Grows with the places asked for.
class GradedNormals {
 public:
  explicit GradedNormals(const GradedTerrain& graded) : graded_(graded) {}

  /// To the bit what normals_at gives. O(1) where the place has been asked for before.
  Vec3 at(GridPoint p, HeightLayer layer);

  const GradedTerrain& graded() const { return graded_; }

 private:
  struct PlaceHash {
    std::size_t operator()(GridPoint place) const;
  };
  const GradedTerrain& graded_;
  std::unordered_map<GridPoint, std::array<Vec3, kHeightLayers>, PlaceHash> known_;
};

}  // namespace citykiln::ground
