#include "compiler/structures/tunnel.h"

#include <algorithm>
#include <array>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/ground/grading/span_influence.h"
#include "compiler/structures/deck.h"

namespace citykiln::structures {
namespace {

// How far a frame stands out before the mouth, and how broad and how high it is beyond the opening.
constexpr double kFrameOut_m = 0.5, kFrameSide_m = 0.6, kFrameTop_m = 0.8, kFrameFoot_m = 0.5;
// What the land over it is looked at for, along the way.
constexpr double kLook_m = 4;

bool is_covered(const Span& tunnel, std::span<const Rib> ribs, double at_m, const map::Heightfield& heights) {
  const Rib rib = rib_at(ribs, at_m);
  return map::height_m_at(heights, rib.at) >= rib.z_m + ground::bore_height_m(tunnel);
}

void add_concrete(Mesh&& mesh, const Span& tunnel, GeneratedStructure& generated) {
  generated.meshes.push_back({std::move(mesh), materials::Material::kConcrete, materials::kNoTint, tunnel.id.osm});
}

bool is_mouth(const SpanEnd& end) { return end.kind == EndKind::kGround || end.kind == EndKind::kBesideRoad; }

// Round from the right end of the road to its left one.
Section lining_of(const Section& road, double high_m) {
  const Corner left = road.front(), right = road.back();
  return {right, {right.left_m, high_m}, {left.left_m, high_m}, left};
}

Mesh lining(const Span& tunnel, std::span<const Rib> ribs, const Section& road, double high_m) {
  Mesh mesh;
  add_kerb_faces(ribs, road, mesh);
  const Section round = lining_of(road, high_m);
  for (std::size_t i = 0; i + 1 < round.size(); ++i) add_band(ribs, round[i], round[i + 1], mesh);
  // an end wall is seen from inside, as a tube's other cap is from outside
  if (tunnel.from.kind == EndKind::kFree) add_cap(ribs.front(), closed_section(road, round), false, mesh);
  if (tunnel.to.kind == EndKind::kFree) add_cap(ribs.back(), closed_section(road, round), true, mesh);
  return mesh;
}

Rib moved_along(Rib rib, double by_m) {
  rib.at = rib.at - left_of(unit(rib.out)) * by_m;
  return rib;
}

void add_frame(const Rib& mouth, double outwards, const Section& road, double high_m, Mesh& mesh) {
  const double l = road.front().left_m, r = road.back().left_m, foot = -kFrameFoot_m, top = high_m + kFrameTop_m;
  const Section frame = {{l + kFrameSide_m, foot},
                         {l + kFrameSide_m, top},
                         {r - kFrameSide_m, top},
                         {r - kFrameSide_m, foot},
                         {r, foot},
                         {r, high_m},
                         {l, high_m},
                         {l, foot}};
  std::array ribs = {mouth, moved_along(mouth, outwards * kFrameOut_m)};
  if (outwards < 0) std::swap(ribs[0], ribs[1]);
  add_tube(ribs, frame, mesh);
}

}  // namespace

bool is_underground(const Span& tunnel, const map::Heightfield& heights) {
  const std::vector<Rib> ribs = ribs_of(tunnel);
  if (ribs.empty() || tunnel.profile.empty()) return false;
  const double from_m = ribs.front().along_m, to_m = ribs.back().along_m;
  const double first_m = from_m + (is_mouth(tunnel.from) ? kPortal_m : 0),
               last_m = to_m - (is_mouth(tunnel.to) ? kPortal_m : 0);
  if (first_m >= last_m) return is_covered(tunnel, ribs, (from_m + to_m) / 2, heights);
  int looked = 0, covered = 0;
  for (double at_m = first_m; at_m <= last_m; at_m += kLook_m, ++looked)
    covered += is_covered(tunnel, ribs, at_m, heights) ? 1 : 0;
  return covered >= kMinCoveredShare * looked;
}

GeneratedStructure generate_tunnel(const Span& tunnel, double tolerance_m) {
  GeneratedStructure generated;
  const std::vector<Rib> all = ribs_of(tunnel);
  if (all.empty() || !tunnel.is_bored) return generated;
  const DeckDimensions shape = deck_dimensions(tunnel, 0);
  // half for ribs, half for frames and kerbs
  const SimplifiedRibs few = simplify_ribs(all, shape.left_m, shape.right_m, tolerance_m / 2);
  const bool has_kerbs = has_detail(Detail::kRoadSurfaces, tolerance_m), has_frames = tolerance_m / 2 < kFrameTop_m;
  const Section road = add_road(tunnel, few.ribs, has_kerbs, tolerance_m, generated);
  const double high_m = ground::bore_height_m(tunnel);
  Mesh mesh = lining(tunnel, few.ribs, road, high_m);
  if (has_frames && is_mouth(tunnel.from)) add_frame(few.ribs.front(), -1, road, high_m, mesh);
  if (has_frames && is_mouth(tunnel.to)) add_frame(few.ribs.back(), 1, road, high_m, mesh);
  add_concrete(std::move(mesh), tunnel, generated);
  generated.error_m = few.error_m + std::max(has_kerbs ? 0 : ground::kKerbRise_m, has_frames ? 0 : kFrameTop_m);
  return generated;
}

}  // namespace citykiln::structures
