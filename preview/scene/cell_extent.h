// Where a cell has anything: what is kept of a cell that was freed, so that rays which miss it need not wait for it.
//
//     ─────ray──────────────►        a grid of columns over the cell's box, each from its lowest to its highest point;
//        ▁▁█▁▁  ▁█▁▁▁▁▁▁             the ray needs the cell only if it meets a column
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstddef>

namespace citykiln::preview {

/// Total; a box without anything in it is met by no ray. 8 kB.
class CellExtent {
 public:
  /// @param box  Of the cell, about the world's origin.
  explicit CellExtent(const RTCBounds& box);

  /// Adds a box that lies in the cell's.
  void add(const RTCBounds& box);
  /// False only if the ray, between its ends, is farther than rounding errors from all boxes that were added.
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
