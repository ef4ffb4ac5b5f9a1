// Heights of the carved ground while a cell gets known, each made once: rings share their corners, lines their ends,
// and where they were cut the ground is followed from.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <unordered_map>

#include "compiler/ground/grading/carving.h"

namespace citykiln::ground {

/// Of one carving, which must outlive it. Grows with the places asked for.
class CarvedHeights {
 public:
  explicit CarvedHeights(const Carving& carving) : carving_(carving) {}

  /// To the bit what sound() gives. O(1) where the place has been asked for before. Stays where it is.
  const Sounding& at(Vec2 p);

  /// The heights of places that nobody asks for again: not kept.
  Heights once_at(Vec2 p) const;

  const Carving& carving() const { return carving_; }

 private:
  struct PlaceHash {
    std::size_t operator()(Vec2 place) const;
  };
  const Carving& carving_;
  std::pmr::monotonic_buffer_resource memory_;
  std::pmr::unordered_map<Vec2, Sounding, PlaceHash> known_{&memory_};
};

}  // namespace citykiln::ground
