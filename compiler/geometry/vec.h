// 2D and 3D vectors. Frames and units are stated at each use. If nothing is stated, they are metres on the map plane
// ("plane metres"): x east, y north, z up (compiler/map/plane/plane.h).
#pragma once

#include <cmath>
#include <compare>

namespace citykiln {

struct Vec2 {
  double x = 0, y = 0;
  auto operator<=>(const Vec2&) const = default;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
inline Vec2 operator*(double s, Vec2 a) { return a * s; }
inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Returns the z component of a × b: positive if b points to the left of a.
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
inline double distance(Vec2 a, Vec2 b) { return length(b - a); }
/// Returns twice the signed area of a triangle: positive if a, b, c turn left.
inline double twice_area(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }
/// Returns the vector turned counter-clockwise by a right angle.
inline Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }
/// Returns the vector scaled to length 1; {0, 0} for {0, 0}.
inline Vec2 unit(Vec2 a) {
  const double l = length(a);
  return l > 0 ? a * (1 / l) : a;
}

struct Vec3 {
  double x = 0, y = 0, z = 0;
  auto operator<=>(const Vec3&) const = default;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec3 operator*(double s, Vec3 a) { return a * s; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 unit(Vec3 a) {
  const double l = length(a);
  return l > 0 ? a * (1 / l) : a;
}
inline Vec2 in_plan(Vec3 a) { return {a.x, a.y}; }
inline Vec3 at_height(Vec2 a, double z) { return {a.x, a.y, z}; }

}  // namespace citykiln
