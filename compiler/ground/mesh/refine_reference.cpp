#include "compiler/ground/mesh/refine_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "compiler/geometry/snap.h"
#include "compiler/ground/grading/bend_points.h"

namespace citykiln::ground {
namespace {

// Shorter edges are not split: they cannot be far off, and vertical steps would be split for ever.
constexpr double kShortest_m = 1;

// Allowed error, and least distance of new points from vertices and fixed edges. Roads are seen most, and so smooth
// that accuracy costs little; paths are narrow.
struct Accuracy {
  double error_m, nearest_m;
};

Accuracy accuracy_of(HeightLayer layer) {
  const bool is_road = layer == HeightLayer::kRoad || layer == HeightLayer::kCarriageway;
  return is_road ? Accuracy{kQuantum_m, 0.25} : Accuracy{kReferenceError_m, 0.5};
}

struct RefiningReference {
  Delaunay triangulation;
  std::vector<std::uint32_t> face_cover;
  std::vector<Heights> heights;
  std::span<const FaceHeight> face_heights;
  const GradedTerrain& graded;
  std::vector<bool> is_seen{};         // its edges need not be sampled again
  std::vector<bool> is_centre_good{};  // nor its centre

  Vec2 place(std::uint32_t v) const { return plane_point(triangulation.vertices()[v]); }

  std::array<Vec2, 3> corners_of(std::uint32_t f) const {
    const auto& v = triangulation.faces()[f].vertices;
    return {place(v[0]), place(v[1]), place(v[2])};
  }

  FaceHeight height_of(std::uint32_t f) const {
    return face_cover[f] == kNoLandCover ? FaceHeight{} : face_heights[face_cover[f]];
  }

  // The linear interpolation at the centroid of some vertices.
  double mean_m(std::initializer_list<std::uint32_t> vertices, HeightLayer layer) const {
    double sum_m = 0;
    for (const std::uint32_t v : vertices) sum_m += layer_height_m(heights[v], layer);
    return sum_m / static_cast<double>(vertices.size());
  }
};

double twice_area_m2(const std::array<Vec2, 3>& c) { return cross(c[1] - c[0], c[2] - c[0]); }

double longest_m(const std::array<Vec2, 3>& c) {
  return std::max({distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0])});
}

// A sample with its error.
struct FaceSample {
  double off_m = 0;
  Vec2 at;
  Heights heights{};
};

void keep_worse(FaceSample& worst, const GradedTerrain& graded, Vec2 at, double straight_m, HeightLayer layer) {
  const Heights heights = heights_at(graded, at);
  const double off_m = std::abs(straight_m - layer_height_m(heights, layer));
  if (off_m > worst.off_m) worst = {off_m, at, heights};
}

// Samples the centre, unless known to be good, and the middles of edges that may be split; returns the worst.
FaceSample worst_sample(RefiningReference& all, std::uint32_t f, HeightLayer layer, double error_m) {
  const DelaunayFace& face = all.triangulation.faces()[f];
  const auto& v = face.vertices;
  const std::array<Vec2, 3> c = all.corners_of(f);
  FaceSample worst;
  if (!all.is_centre_good[f]) {
    const Vec2 centre = snapped((c[0] + c[1] + c[2]) * (1.0 / 3));
    keep_worse(worst, all.graded, centre, all.mean_m({v[0], v[1], v[2]}, layer), layer);
    all.is_centre_good[f] = worst.off_m <= error_m;
  }
  for (int i = 0; i < 3; ++i) {
    const Vec2 a = c[(i + 1) % 3], b = c[(i + 2) % 3];
    if (face.is_constrained[i] || all.is_seen[face.neighbours[i]] || distance(a, b) < 2 * kShortest_m) continue;
    const double straight_m = all.mean_m({v[(i + 1) % 3], v[(i + 2) % 3]}, layer);
    keep_worse(worst, all.graded, snapped((a + b) * 0.5), straight_m, layer);
  }
  return worst;
}

// Returns whether p is too near to a corner or to a fixed edge.
bool is_crowded(const RefiningReference& all, std::uint32_t f, Vec2 p, double nearest_m) {
  const std::array<Vec2, 3> c = all.corners_of(f);
  for (int i = 0; i < 3; ++i) {
    const Vec2 a = c[(i + 1) % 3], b = c[(i + 2) % 3];
    if (distance(p, c[i]) < nearest_m) return true;
    if (!all.triangulation.faces()[f].is_constrained[i]) continue;
    if (cross(b - a, p - a) < nearest_m * distance(a, b)) return true;
  }
  return false;
}

// Faces of standing water are level whatever lies under them, and small faces cannot be split.
bool may_be_off(const RefiningReference& all, std::uint32_t f, double nearest_m) {
  if (all.height_of(f).level_m) return false;
  const std::array<Vec2, 3> c = all.corners_of(f);
  const double longest = longest_m(c);
  return longest >= 2 * kShortest_m && twice_area_m2(c) >= nearest_m * longest;
}

// Returns the changed faces; none where the face is good or no point may be inserted.
std::span<const std::uint32_t> mend(RefiningReference& all, std::uint32_t f) {
  const HeightLayer layer = all.height_of(f).layer;
  const auto [error_m, nearest_m] = accuracy_of(layer);
  if (!may_be_off(all, f, nearest_m)) return {};
  const FaceSample worst = worst_sample(all, f, layer, error_m);
  all.is_seen[f] = true;
  if (worst.off_m <= error_m) return {};
  const std::uint32_t split = all.triangulation.face_to_split(grid_point(worst.at), f);
  if (split == kNoFace || is_crowded(all, split, worst.at, nearest_m)) return {};
  const std::uint32_t surface = all.face_cover[split];
  const auto changed = all.triangulation.insert(grid_point(worst.at), split);
  all.heights.push_back(worst.heights);
  const std::size_t count = all.triangulation.faces().size();
  all.face_cover.resize(count), all.is_seen.resize(count), all.is_centre_good.resize(count);
  for (const std::uint32_t c : changed)
    all.face_cover[c] = surface, all.is_seen[c] = false, all.is_centre_good[c] = false;
  return changed;
}

}  // namespace

RefinedReference refine_reference(Partition&& partition, std::span<const FaceHeight> face_heights,
                                  const GradedHeights& heights) {
  RefiningReference all{
      std::move(partition.triangulation), std::move(partition.face_cover), {}, face_heights, heights.graded()};
  all.is_seen.resize(all.face_cover.size()), all.is_centre_good.resize(all.face_cover.size());
  for (const GridPoint p : all.triangulation.vertices()) all.heights.push_back(heights.uncached_at(plane_point(p)));
  std::deque<std::uint32_t> waiting;
  for (std::uint32_t f = 0; f < all.face_cover.size(); ++f) waiting.push_back(f);
  for (; !waiting.empty(); waiting.pop_front())
    for (const std::uint32_t changed : mend(all, waiting.front())) waiting.push_back(changed);
  return {std::move(all.triangulation), std::move(all.heights)};
}

}  // namespace citykiln::ground
