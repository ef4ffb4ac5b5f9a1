#include "compiler/verify/heights/measure_road_faces.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/ground/grading/road_influence.h"

namespace citykiln::verify {
namespace {

constexpr double kFaceSample_m = 4, kFaceBucket_m = 32;

/// Closer than this to another road's edge, heights are blended.
constexpr double kMixed_m = 2 * ground::kBlend_m;

/// A straight piece of a road's axis, and the distance up to which the road influences heights.
struct Piece {
  Vec2 a, b;
  double from_m = 0, to_m = 0, radius_m = 0;
  std::uint32_t road = 0;
};

std::vector<Piece> pieces_of(const std::vector<roads::Road>& roads) {
  std::vector<Piece> pieces;
  for (std::uint32_t r = 0; r < roads.size(); ++r) {
    const std::vector<double> along = roads::distances_along(roads[r]);
    const double radius_m = roads::max_offset_m(roads[r]) + kMixed_m;
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
      pieces.push_back({roads[r].axis[i], roads[r].axis[i + 1], along[i], along[i + 1], radius_m, r});
  }
  return pieces;
}

/// True where another road, or another bend of the same road, influences the height.
bool is_mixed(const std::vector<Piece>& pieces, const BoxGrid& grid, std::uint32_t own, Vec2 p) {
  return std::ranges::any_of(boxes_about(grid, p), [&](std::uint32_t i) {
    return i != own && distance_to_segment(pieces[i].a, pieces[i].b, p) < pieces[i].radius_m;
  });
}

double gap_m(const roads::Road& road, double at_m, bool has_kerbs, const std::vector<double>& faces_m) {
  const double top_m = knot_at(road.profile, at_m).z_m;
  double least_m = 1e9;
  for (const double z_m : faces_m) {
    least_m = std::min(least_m, std::abs(z_m - top_m));
    if (has_kerbs) least_m = std::min(least_m, std::abs(z_m - top_m + ground::kKerbRise_m));
  }
  return least_m;
}

/// Visits sample places on a piece beyond the influence of its neighbours along the road.
template <typename Visit>
void for_each_place(const Piece& piece, Visit visit) {
  const int n = static_cast<int>((piece.to_m - piece.from_m) / kFaceSample_m);
  for (int k = 0; k <= n; ++k) {
    const double t = (k + 0.5) / (n + 1);
    visit(piece.a + (piece.b - piece.a) * t, piece.from_m + (piece.to_m - piece.from_m) * t);
  }
}

}  // namespace

RoadFaces combined(const RoadFaces& a, const RoadFaces& b) {
  const RoadFaces& worst = b.largest_gap_m > a.largest_gap_m ? b : a;
  return {a.places + b.places, worst.largest_gap_m, worst.worst, worst.at};
}

RoadFaces measure_road_faces(const scene::Chunk& chunk, const Box2& box, bool has_kerbs,
                             const RoadSurfaceAt& faces_at) {
  assert(!box.is_empty());
  const std::vector<Piece> pieces = pieces_of(chunk.roads);
  std::vector<Box2> boxes;
  for (const Piece& piece : pieces) boxes.push_back(box_of_segment(piece.a, piece.b).widened(piece.radius_m));
  const BoxGrid grid = grid_of(boxes, kFaceBucket_m);
  RoadFaces result;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const roads::Road& road = chunk.roads[pieces[i].road];
    if (road.profile.empty()) continue;
    for_each_place(pieces[i], [&](Vec2 p, double at_m) {
      if (!box.contains(p) || is_mixed(pieces, grid, i, p)) return;
      const std::vector<double> faces_m = faces_at(road, p);
      if (faces_m.empty()) return;
      ++result.places;
      const double here_m = gap_m(road, at_m, has_kerbs, faces_m);
      if (here_m > result.largest_gap_m) result.largest_gap_m = here_m, result.worst = road.id.osm, result.at = p;
    });
  }
  return result;
}

}  // namespace citykiln::verify
