// Heights of the graded terrain while a cell gets known, each made once: rings share their corners, lines their ends,
// and where they were cut the ground is followed from.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <unordered_map>

#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::ground {

/// Of one carving, which must outlive it. Grows with the places asked for.
class GradedHeights {
 public:
  explicit GradedHeights(const GradedTerrain& graded) : graded_(graded) {}

  /// To the bit what sound() gives. O(1) where the place has been asked for before. Stays where it is.
  const HeightSample& at(Vec2 p);

  /// The heights of places that nobody asks for again: not kept.
  Heights uncached_at(Vec2 p) const;

  const GradedTerrain& graded() const { return graded_; }

 private:
  struct PlaceHash {
    std::size_t operator()(Vec2 place) const;
  };
  const GradedTerrain& graded_;
  std::pmr::monotonic_buffer_resource memory_;
  std::pmr::unordered_map<Vec2, HeightSample, PlaceHash> known_{&memory_};
};

}  // namespace citykiln::ground
