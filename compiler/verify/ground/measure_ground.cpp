#include "compiler/verify/ground/measure_ground.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "compiler/contract/random_sequence.h"

namespace citykiln::verify {
namespace {

/// A random place in each square of a lattice, with the lowest ground there.
struct Lattice {
  Box2 box;
  int a_side;
  std::vector<Vec2> places;
  std::vector<double> lowest_m;
  std::vector<OsmId> features;  ///< The feature of the lowest ground.

  std::size_t number(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(a_side) + static_cast<std::size_t>(i);
  }
};

Lattice lattice_of(const Box2& box, int a_side) {
  Lattice lattice{box, a_side, {}, {}, {}};
  const RandomSequence draw(0, StableId{0}, "samples of the ground");
  std::uint32_t dice = 0;
  for (int j = 0; j < a_side; ++j)
    for (int i = 0; i < a_side; ++i) {
      const double u = (i + draw.unit(dice++)) / a_side, v = (j + draw.unit(dice++)) / a_side;
      lattice.places.push_back({box.min.x + u * box.width(), box.min.y + v * box.height()});
    }
  lattice.lowest_m.assign(lattice.places.size(), std::numeric_limits<double>::infinity());
  lattice.features.resize(lattice.places.size());
  return lattice;
}

/// Lowers the lattice heights at all places inside the triangle.
void lower(Lattice& lattice, const GroundFace& face) {
  const std::array<Vec3, 3>& t = face.corners;
  const double area = twice_area(in_plan(t[0]), in_plan(t[1]), in_plan(t[2]));
  if (area <= 0) return;
  Box2 box;
  for (const Vec3& corner : t) box.grow(in_plan(corner));
  const auto square = [&](double from, double origin, double size) {
    return static_cast<int>(std::clamp(std::floor((from - origin) / size * lattice.a_side), 0.0, lattice.a_side - 1.0));
  };
  const auto column = [&](double x) { return square(x, lattice.box.min.x, lattice.box.width()); };
  const auto row = [&](double y) { return square(y, lattice.box.min.y, lattice.box.height()); };
  for (int j = row(box.min.y); j <= row(box.max.y); ++j) {
    for (int i = column(box.min.x); i <= column(box.max.x); ++i) {
      const Vec2 p = lattice.places[lattice.number(i, j)];
      const double a = twice_area(p, in_plan(t[1]), in_plan(t[2])), b = twice_area(in_plan(t[0]), p, in_plan(t[2]));
      const double c = area - a - b;
      // a place on an edge counts for both triangles despite rounding
      const double slack = -1e-9 * area;
      if (a < slack || b < slack || c < slack) continue;
      const std::size_t n = lattice.number(i, j);
      const double z_m = (a * t[0].z + b * t[1].z + c * t[2].z) / area;
      if (z_m < lattice.lowest_m[n]) lattice.lowest_m[n] = z_m, lattice.features[n] = face.feature;
    }
  }
}

void keep_largest_error(GroundSamples& samples, double error_m, Vec2 at) {
  if (error_m > samples.error_m) samples.error_m = error_m, samples.at = at;
}

}  // namespace

int samples_a_side(std::size_t faces) {
  constexpr double kSamplesPerFace = 2;
  const double a_side = std::ceil(std::sqrt(kSamplesPerFace * static_cast<double>(faces)));
  return static_cast<int>(std::clamp<double>(a_side, kFewestSamplesASide, kMostSamplesASide));
}

GroundSamples sample_ground(const bake::BakedTile& tile, const DeviationAt& deviation_m, const Box2& box, int a_side,
                            const ExpectsGround& expects_ground) {
  assert(a_side > 0 && !box.is_empty());
  Lattice lattice = lattice_of(box, a_side);
  for_each_ground_face(tile, [&](const GroundFace& face) { lower(lattice, face); });

  GroundSamples samples;
  samples.count = lattice.lowest_m.size();
  for (std::size_t i = 0; i < lattice.places.size(); ++i) {
    if (std::isinf(lattice.lowest_m[i])) {
      if (expects_ground && !expects_ground(lattice.places[i])) continue;
      if (samples.uncovered++ == 0) samples.hole = lattice.places[i];
    } else {
      keep_largest_error(samples, deviation_m(lattice.places[i], lattice.lowest_m[i], lattice.features[i]),
                         lattice.places[i]);
    }
  }
  return samples;
}

}  // namespace citykiln::verify
