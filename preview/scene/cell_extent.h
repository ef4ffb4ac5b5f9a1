// The space that a cell's meshes take up. It is kept when a cell is freed, so that rays which miss the meshes need not
// wait for the cell.
//
//     ─────ray──────────────►        a grid of columns over the cell's box, each from its lowest to its highest point;
//        ▁▁█▁▁  ▁█▁▁▁▁▁▁             the ray needs the cell only if it meets a column
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstddef>

namespace citykiln::preview {

/// A grid of 32 by 32 columns over a cell's box, with a range of heights in each. A grid to which nothing was added is
/// met by no ray. 8 kB.
class CellExtent {
 public:
  /// @param box  The cell's box, relative to the world's origin.
  explicit CellExtent(const RTCBounds& box);

  /// Adds a box that lies in the cell's box.
  void add(const RTCBounds& box);
  /// Returns false only if the ray, between its ends, is farther than rounding errors from all boxes that were added.
  /// O(columns across).
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
