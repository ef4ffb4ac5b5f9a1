// Faces: planar polygons in space.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/geometry/vec.h"

namespace citykiln::grammars {

/// The points of a closed polygon in order, without a repeated first point at the end. Four points are stored inline,
/// because most faces are quadrilaterals. Converts to std::span<const Vec3>, which boost::container::small_vector does
/// not.
class Ring3 {
 public:
  using value_type = Vec3;
  using iterator = Vec3*;
  using const_iterator = const Vec3*;

  Ring3() = default;
  Ring3(std::initializer_list<Vec3> points) { append(points.begin(), points.end()); }
  template <typename Iterator>
  Ring3(Iterator from, Iterator to) {
    append(from, to);
  }

  std::size_t size() const { return many_.empty() ? few_count_ : many_.size(); }
  bool empty() const { return size() == 0; }
  Vec3* data() { return many_.empty() ? few_.data() : many_.data(); }
  const Vec3* data() const { return many_.empty() ? few_.data() : many_.data(); }
  Vec3* begin() { return data(); }
  Vec3* end() { return data() + size(); }
  const Vec3* begin() const { return data(); }
  const Vec3* end() const { return data() + size(); }
  auto rbegin() const { return std::make_reverse_iterator(end()); }
  auto rend() const { return std::make_reverse_iterator(begin()); }
  Vec3& operator[](std::size_t i) { return data()[i]; }
  const Vec3& operator[](std::size_t i) const { return data()[i]; }
  const Vec3& front() const { return *begin(); }
  const Vec3& back() const { return *(end() - 1); }

  void reserve(std::size_t count) {
    if (count > few_.size()) many_.reserve(count);
  }
  void push_back(Vec3 p) {
    if (many_.empty() && few_count_ < few_.size()) {
      few_[few_count_++] = p;
    } else {
      if (many_.empty()) many_.assign(few_.begin(), few_.begin() + few_count_);
      few_count_ = 0;
      many_.push_back(p);
    }
  }
  void pop_back() {
    assert(!empty());
    if (many_.empty()) {
      --few_count_;
    } else {
      many_.pop_back();
    }
  }
  template <typename Iterator>
  void append(Iterator from, Iterator to) {
    for (; from != to; ++from) push_back(*from);
  }

  friend bool operator==(const Ring3& a, const Ring3& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

 private:
  std::array<Vec3, 4> few_;
  std::size_t few_count_ = 0;
  std::vector<Vec3> many_;  ///< All points, if there are more than four.
};

/// The kind of a face, which selectors of comp(f) test. It is set by the operation that made the face.
enum class FaceTag : std::uint8_t {
  kNone,      ///< No tag: selectors test the direction of the face.
  kTop,       ///< A roof plane, however steep.
  kSide,      ///< A gable of a roof.
  kBottom,    ///< The floor below a roof.
  kVertical,  ///< A face that selectors treat as vertical; no operation sets it at present.
  kInside,    ///< The inner part that setback() leaves of a face.
  kBorder     ///< A band that setback() cuts off, or a rim or underside of a roof's overhang.
};

/// A planar polygon, in metres on the map plane with z up. Seen from the side to which the normal points, the outer
/// ring is counter-clockwise and holes are clockwise.
struct Face {
  Ring3 outer;                               ///< The outer border.
  std::vector<Ring3> holes{};                ///< The borders of holes.
  FaceTag tag = FaceTag::kNone;              ///< Its kind.
  bool street = false;                       ///< The face is a wall along a street.
  std::vector<std::uint8_t> street_edges{};  ///< By edge of `outer`: 1 if it is along a street; empty: none is.
  bool operator==(const Face&) const = default;
};

/// True if a face has an area: shapes of edges and points (comp(e), scatter) have faces of two points and of one.
inline bool has_surface(std::span<const Face> faces) {
  for (const Face& face : faces)
    if (face.outer.size() > 2) return true;
  return false;
}

/// The plane of points p where dot(normal, p) = offset_m. `normal` has length 1.
struct CutPlane {
  Vec3 normal;
  double offset_m = 0;
};

/// The distance below which a point counts as on a plane: 6e-8 m, above the rounding error of coordinates up to 100 km.
inline constexpr double kOnPlane_m = 0x1p-24;

/// Returns a vector along the normal whose length is twice the area (Newell). O(n).
Vec3 double_area_vector_m2(std::span<const Vec3> ring);
Vec3 double_area_vector_m2(const Face& face);
/// Returns the unit normal of the outer ring; {0, 0, 0} for a face without area.
Vec3 normal_of(const Face& face);
double area_m2(const Face& face);
/// Returns the face seen from its other side: rings in reverse order.
Face reversed(const Face& face);
/// Returns the extent of the corners along the normal; 0 if it is at most kOnPlane_m. This extent bounds the distance
/// between two triangulations of the face. The coordinates of roof planes are rounded, so these planes are planar only
/// to about a millimetre. O(n).
double bend_m(const Face& face);

/// Calls `with` on every vertex.
template <typename Visitor>
void each_vertex(Face& face, Visitor with) {
  for (Vec3& p : face.outer) with(p);
  for (Ring3& hole : face.holes)
    for (Vec3& p : hole) with(p);
}
template <typename Visitor>
void each_vertex(const Face& face, Visitor with) {
  each_vertex(const_cast<Face&>(face), [&](const Vec3& p) { with(p); });
}

std::size_t vertex_count(std::span<const Face> faces);

/// A right-handed frame of a face's plane: the origin is the first point, x is along the first edge that is not
/// degenerate, z is along the normal.
struct FaceFrame {
  Vec3 origin, x, y, z;
  Vec2 to_plane(Vec3 p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
  Vec3 to_space(Vec2 p) const { return origin + x * p.x + y * p.y; }
};
/// Returns the frame of a face's plane.
FaceFrame frame_of(const Face& face);
/// Returns the face in the coordinates of the frame.
Polygon flat(const Face& face, const FaceFrame& frame);
/// Returns a polygon in coordinates of the frame as a face in space. Points within `snap_m` of a vertex of `like`
/// become that vertex, bit for bit.
Face lifted(const Polygon& polygon, const FaceFrame& frame, const Face& like, double snap_m);

}  // namespace citykiln::grammars
