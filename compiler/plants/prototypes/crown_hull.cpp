#include "compiler/plants/prototypes/crown_hull.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/trig.h"

namespace citykiln::plants {
namespace {

constexpr int kSides = 3, kBands = 2, kHullPieces = 8;
// Share of a band's leaves within its ring, so that single twigs do not widen it.
constexpr double kWithin = 0.7;
// Circumradius of a triangle whose mean width is that of a circle of radius 1 (Cauchy: the mean width is girth / π).
constexpr double kCircumradius = 1.2092;

struct HullRing {
  double height = 0, radius = 0;
};

double ring_radius(std::vector<double>& radii) {
  if (radii.empty()) return 0;
  const auto at = static_cast<std::size_t>(kWithin * static_cast<double>(radii.size() - 1));
  std::ranges::nth_element(radii, radii.begin() + static_cast<std::ptrdiff_t>(at));
  return radii[at];
}

// Rings in the middle of equal bands from the lowest to the highest leaf.
std::vector<HullRing> hull_rings_of(const Foliage& foliage) {
  const auto [low, high] = std::ranges::minmax(foliage.cards, {}, [](const Card& c) { return c.centre().z; });
  const double foot = low.centre().z, top = high.centre().z;
  std::array<std::vector<double>, kBands> radii;
  for (const Card& card : foliage.cards) {
    const double share = (card.centre().z - foot) / std::max(1e-9, top - foot);
    radii[static_cast<std::size_t>(std::clamp(static_cast<int>(share * kBands), 0, kBands - 1))].push_back(
        length(in_plan(card.centre())));
  }
  std::vector<HullRing> rings;
  for (int b = 0; b < kBands; ++b)
    rings.push_back({foot + (top - foot) * (b + 0.5) / kBands, ring_radius(radii[static_cast<std::size_t>(b)])});
  return rings;
}

Mesh body_of(const std::vector<HullRing>& rings, double foot, double top) {
  Mesh mesh;
  const auto n = static_cast<std::uint32_t>(kSides);
  const auto push = [&](Vec3 at) { mesh.positions.push_back(at); };
  push({0, 0, foot});
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (int i = 0; i < kSides; ++i)
      push(at_height(direction_of((i + 0.5 * r) / kSides) * (rings[r].radius * kCircumradius), rings[r].height));
  push({0, 0, top});
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({0, 1 + j, 1 + i});
    for (std::uint32_t r = 0; r + 1 < rings.size(); ++r) {
      const std::uint32_t a = 1 + r * n + i, b = 1 + r * n + j;
      mesh.triangles.push_back({a, b, a + n});
      mesh.triangles.push_back({b, b + n, a + n});
    }
    mesh.triangles.push_back({last, last - n + i, last - n + j});
  }
  const Vec3 crown_centre{0, 0, foot + 0.4 * (top - foot)};
  for (const Vec3 p : mesh.positions) mesh.normals.push_back(unit(p - crown_centre));
  return mesh;
}

// Sample points on a mesh: a grid of kHullPieces steps on each triangle.
std::vector<Vec3> places_on(const Mesh& mesh) {
  std::vector<Vec3> places;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 corner = mesh.positions[a], u = mesh.positions[b] - corner, v = mesh.positions[c] - corner;
    for (int i = 0; i <= kHullPieces; ++i)
      for (int j = 0; i + j <= kHullPieces; ++j)
        places.push_back(corner + u * (i / double{kHullPieces}) + v * (j / double{kHullPieces}));
  }
  return places;
}

// The nearest of many things to a sequence of places. Consecutive places and things are near each other, so the search
// begins at the last result.
struct Nearest {
  std::size_t count;
  std::size_t last = 0;

  // The distance to the nearest thing if it exceeds `known`, else any smaller number.
  template <typename Distance>
  double beyond(double known, Distance distance_to) {
    double nearest = 1e300;
    std::size_t near = last;
    for (std::size_t i = 0; i < count && nearest > known; ++i) {
      const std::size_t thing = last + i < count ? last + i : last + i - count;
      const double off = distance_to(thing);
      if (off < nearest) nearest = off, near = thing;
    }
    last = near;
    return nearest;
  }
};

double longest_side_m(const Mesh& mesh) {
  double longest = 0;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, length(mesh.positions[t[i]] - mesh.positions[t[(i + 1) % 3]]));
  return longest;
}

// Bound of the Hausdorff distance between hull and cards, at least `least_m`: from card corners to samples of the hull,
// and back. No point of the hull is farther from its nearest sample than a piece's side / √3.
double hull_error_m(const Mesh& mesh, const Foliage& foliage, double least_m) {
  const std::vector<Vec3> places = places_on(mesh);
  const std::vector<Card>& cards = foliage.cards;
  double there = least_m;
  Nearest place{places.size()};
  for (const Card& card : cards)
    for (const Vec3 corner : corners_of(card))
      there = std::max(there, place.beyond(there, [&](std::size_t i) { return length(places[i] - corner); }));
  const double piece_m = longest_side_m(mesh) / kHullPieces / std::sqrt(3.0);
  double back = std::max(0.0, there - piece_m);
  Nearest card{cards.size()};
  for (const Vec3 p : places)
    back = std::max(back, card.beyond(back, [&](std::size_t i) { return distance(cards[i], p); }));
  return std::max(there, back + piece_m);
}

// The 2nd and 98th percentile of card centres on an axis.
std::array<double, 2> percentiles_of(const Foliage& foliage, double Vec3::*axis) {
  std::vector<double> places;
  for (const Card& card : foliage.cards) places.push_back(card.centre().*axis);
  std::ranges::sort(places);
  const std::size_t beyond = places.size() / 50;
  return {places[beyond], places[places.size() - 1 - beyond]};
}

}  // namespace

CrownHull crown_hull(const Foliage& foliage) {
  CrownHull hull;
  if (foliage.cards.empty()) return hull;
  const auto [low, high] = std::ranges::minmax(foliage.cards, {}, [](const Card& c) { return c.centre().z; });
  const double foot = low.centre().z, top = high.centre().z;
  // its foot is near the ground, so that the trunk's foot is within the error
  hull.mesh =
      body_of(hull_rings_of(foliage), std::min(foot - 0.1 * (top - foot), 0.25 * top), top + 0.02 * (top - foot));
  hull.error_m = hull_error_m(hull.mesh, foliage, length(hull.mesh.positions.front()));
  return hull;
}

CrownHull crown_box(const Foliage& foliage) {
  CrownHull hull;
  if (foliage.cards.empty()) return hull;
  std::array bounds = {percentiles_of(foliage, &Vec3::x), percentiles_of(foliage, &Vec3::y),
                       percentiles_of(foliage, &Vec3::z)};
  bounds[2][0] = 0;
  const auto at = [&](std::size_t axis, int end) { return bounds[axis][static_cast<std::size_t>(end)]; };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1}) {
      const auto first = static_cast<std::uint32_t>(hull.mesh.positions.size());
      // counter-clockwise from outside
      for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        const std::array<double, 3> p = {at(axis, end), at((axis + 1) % 3, end == 1 ? u : v),
                                         at((axis + 2) % 3, end == 1 ? v : u)};
        const std::array<double, 3> out = {end == 1 ? 1.0 : -1.0, 0, 0};
        hull.mesh.positions.push_back({p[(3 - axis) % 3], p[(4 - axis) % 3], p[(5 - axis) % 3]});
        hull.mesh.normals.push_back({out[(3 - axis) % 3], out[(4 - axis) % 3], out[(5 - axis) % 3]});
      }
      hull.mesh.triangles.push_back({first, first + 1, first + 2});
      hull.mesh.triangles.push_back({first, first + 2, first + 3});
    }
  hull.error_m = hull_error_m(hull.mesh, foliage, 0);
  return hull;
}

}  // namespace citykiln::plants
