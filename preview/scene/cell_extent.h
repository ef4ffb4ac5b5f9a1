// The extent of a cell: the space that the cell's meshes take up. A cell has the meshes on one piece of the ground,
// which may be freed and generated again. The extent is kept, so that rays which miss the meshes need not wait for the
// cell.
//
//     ─────ray──────────────►        a grid of columns over the cell's box, each from its lowest to its highest point;
//        ▁▁█▁▁  ▁█▁▁▁▁▁▁             the ray needs the cell only if it meets a column
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstddef>

namespace citykiln::preview {

/// A grid of 32 by 32 columns over a cell's box, with a range of heights in each. No ray meets an empty grid. 8 kB.
class CellExtent {
 public:
  /// @param box  The cell's box, relative to the world's origin.
  explicit CellExtent(const RTCBounds& box);

  /// Adds a box that lies in the cell's box.
  void add(const RTCBounds& box);
  /// True if the ray may meet the meshes: if, between its ends, it comes as near as rounding errors to one of the added
  /// boxes. May be true for other rays, never false for these. O(columns across).
  bool may_meet(const RTCRay& ray) const;

 private:
  static constexpr int kAcross = 32;
  struct Column {
    float low, high;
  };
  struct Span {
    int first, last;
  };
  Span span_of(float from, float to, float low, float size) const;

  RTCBounds box_;
  float width_, depth_, margin_;
  std::array<Column, kAcross * kAcross> columns_;
};

}  // namespace citykiln::preview
