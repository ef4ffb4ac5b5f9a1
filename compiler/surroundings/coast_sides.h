// The sides of coastlines: decides by the nearest coastline whether a place is sea or land.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::surroundings {

/// A place as seen from the nearest coastline.
struct CoastSide {
  bool is_sea = false;     ///< True to the right of the nearest segment; false on it.
  bool is_beyond = false;  ///< True if the nearest point is an end of the mapped coast.
  double away_m = 0;       ///< The distance from the coastline, metres.
};

/// Coastlines, which have the sea on their right, with boxes that find the nearest one.
class CoastSides {
 public:
  /// @param coasts  Plane metres. They may be closed (islands), and one may continue another. They
  ///                must outlive this object.
  explicit CoastSides(std::span<const Polyline> coasts);

  /// Returns the side of a place; nothing if there are no coastlines. It is correct if coastlines
  /// do not cross and the nearest one is mapped. An end that no other coastline continues is an end
  /// of the mapped coast: its segment is taken as going on straight there, and is_beyond is true.
  /// The result has the same bits on every CPU. O(n / 16) for n segments, and the segments of runs
  /// of 16 near the nearest point.
  std::optional<CoastSide> at(Vec2 place) const;
  bool is_empty() const { return runs_.empty(); }

 private:
  // Up to 16 segments that follow each other.
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
