// Normals of the carved ground, each made once: four places are asked for one, and levels of a cell share most of their
// vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "compiler/geometry/arrangement.h"
#include "compiler/ground/carving.h"

namespace citykiln::ground {

/// Of one carving, which must outlive it. Grows with the places asked for.
class CarvedNormals {
 public:
  explicit CarvedNormals(const Carving& carving) : carving_(carving) {}

  /// To the bit what normal_at gives. O(1) where the place has been asked for before.
  Vec3 at(GridPoint p, HeightLayer layer);

  const Carving& carving() const { return carving_; }

 private:
  struct Key {
    GridPoint place;
    HeightLayer layer;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  const Carving& carving_;
  std::unordered_map<Key, Vec3, KeyHash> known_;
};

}  // namespace citykiln::ground
