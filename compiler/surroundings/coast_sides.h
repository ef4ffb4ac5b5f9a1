// The sides of coastlines: which places are sea, as far as coastlines are mapped, and beyond.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::surroundings {

/// A place as seen from the nearest coastline.
struct CoastSide {
  bool is_sea = false;     ///< True to the right of the coastline.
  bool is_beyond = false;  ///< True if an end of all coastlines is nearest: the last segment then goes on straight.
  double away_m = 0;       ///< The distance.
};

/// Coastlines, which have the sea on their right.
class CoastSides {
 public:
  /// @param coasts  Plane metres. They may be closed (islands) and continue each other. Must outlive this object.
  explicit CoastSides(std::span<const Polyline> coasts);

  /// Returns the side of a place; nothing without coastlines. Right if coastlines do not cross each other and the
  /// nearest one is mapped. Same bits on every CPU. O(n / 16 + 16) for n segments.
  std::optional<CoastSide> at(Vec2 place) const;
  bool is_empty() const { return runs_.empty(); }

 private:
  // Some segments that follow each other.
  struct Run {
    std::span<const Vec2> points;
    Box2 box;
  };
  struct Nearest;
  void look_in(const Run& run, Vec2 place, Nearest& nearest) const;

  std::vector<Run> runs_;
  std::vector<Vec2> ends_;  // sorted: ends of coastlines that no other one continues
};

}  // namespace citykiln::surroundings
