#include "grammars/shapes/measure.h"

#include <algorithm>
#include <cmath>

namespace citykiln::grammars {
namespace {

bool is_right_angle(Vec3 a, Vec3 b) { return std::abs(dot(unit(a), unit(b))) < 1e-6; }

bool has_reflex_corner(const Face& face) {
  const Vec3 normal = normal_of(face);
  const std::size_t n = face.outer.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 in = unit(face.outer[(i + 1) % n] - face.outer[i]);
    const Vec3 out = unit(face.outer[(i + 2) % n] - face.outer[(i + 1) % n]);
    if (dot(normal, cross(in, out)) < -1e-9) return true;
  }
  return !face.holes.empty();
}

// Three times the volume of the pyramid from `apex` over the face.
double pyramid_m3(const Face& face, Vec3 apex) {
  return dot(double_area_vector_m2(face) * 0.5, face.outer.front() - apex);
}

}  // namespace

double surface_m2(const Shape& shape) {
  double sum = 0;
  for (const Face& face : shape.faces) sum += area_m2(face);
  return sum;
}

double height_m(const Shape& shape) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Face& face : shape.faces) {
    for (const Vec3 p : face.outer) {
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
  }
  return low <= high ? high - low : 0;
}

double volume_m3(const Shape& shape) {
  double sum = 0;
  for (const Face& face : shape.faces) sum += pyramid_m3(face, shape.scope.origin);
  return sum / 3;
}

bool is_rectangular(const Shape& shape) {
  if (shape.faces.size() != 1 || shape.faces[0].outer.size() != 4 || !shape.faces[0].holes.empty()) return false;
  const Ring3& ring = shape.faces[0].outer;
  for (std::size_t i = 0; i < 4; ++i)
    if (!is_right_angle(ring[(i + 1) % 4] - ring[i], ring[(i + 2) % 4] - ring[(i + 1) % 4])) return false;
  return true;
}

bool is_concave(const Shape& shape) { return std::any_of(shape.faces.begin(), shape.faces.end(), has_reflex_corner); }

}  // namespace citykiln::grammars
