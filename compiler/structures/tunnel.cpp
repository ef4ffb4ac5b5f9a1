#include "compiler/structures/tunnel.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/ground/grading/span_influence.h"
#include "compiler/ground/profiles/planned_spans.h"
#include "compiler/structures/deck.h"

namespace citykiln::structures {
namespace {

// Depth of a portal's frame in front of the opening, and its extent beyond it: sideways, upwards, downwards.
constexpr double kFrameOut_m = 0.5, kFrameSide_m = 0.6, kFrameTop_m = 0.8, kFrameFoot_m = 0.5;

bool is_covered(const Span& tunnel, std::span<const Rib> ribs, double at_m, const map::Heightfield& heights) {
  const Rib rib = rib_at(ribs, at_m);
  return map::height_m_at(heights, rib.at) >= rib.z_m + ground::bore_height_m(tunnel);
}

void add_tunnel_concrete(Mesh&& mesh, const Span& tunnel, GeneratedStructure& generated) {
  generated.meshes.push_back({std::move(mesh), materials::Material::kConcrete, materials::kNoTint, tunnel.id.osm});
}

Mesh lining(const Span& tunnel, std::span<const Rib> ribs, const Section& road, double high_m) {
  Mesh mesh;
  add_kerb_faces(ribs, road, mesh);
  // walls and ceiling, from the right end of the road to its left one
  const Corner left = road.front(), right = road.back();
  const Section walls = {right, {right.left_m, high_m}, {left.left_m, high_m}, left};
  for (std::size_t i = 0; i + 1 < walls.size(); ++i) add_band(ribs, walls[i], walls[i + 1], mesh);
  // end walls face inwards, so begin and end are exchanged
  if (tunnel.from.kind == EndKind::kFree) add_cap(ribs.front(), closed_section(road, walls), false, mesh);
  if (tunnel.to.kind == EndKind::kFree) add_cap(ribs.back(), closed_section(road, walls), true, mesh);
  return mesh;
}

Rib moved_along(Rib rib, double by_m) {
  rib.at = rib.at - left_of(unit(rib.out)) * by_m;
  return rib;
}

void add_frame(const Rib& portal, double outwards, const Section& road, double high_m, Mesh& mesh) {
  const double l = road.front().left_m, r = road.back().left_m, foot = -kFrameFoot_m, top = high_m + kFrameTop_m;
  const Section frame = {{l + kFrameSide_m, foot},
                         {l + kFrameSide_m, top},
                         {r - kFrameSide_m, top},
                         {r - kFrameSide_m, foot},
                         {r, foot},
                         {r, high_m},
                         {l, high_m},
                         {l, foot}};
  std::array ribs = {portal, moved_along(portal, outwards * kFrameOut_m)};
  if (outwards < 0) std::swap(ribs[0], ribs[1]);
  add_tube(ribs, frame, mesh);
}

}  // namespace

bool is_underground(const Span& tunnel, const map::Heightfield& heights) {
  const std::vector<Rib> ribs = ribs_of(tunnel);
  if (ribs.empty() || tunnel.profile.empty() || ground::enters_from_above(tunnel, heights)) return false;
  const double from_m = ribs.front().along_m, to_m = ribs.back().along_m;
  const double first_m = from_m + (is_on_ground(tunnel.from) ? ground::kPortalLength_m : 0),
               last_m = to_m - (is_on_ground(tunnel.to) ? ground::kPortalLength_m : 0);
  if (first_m >= last_m) return is_covered(tunnel, ribs, (from_m + to_m) / 2, heights);
  int samples = 0, covered = 0;
  for (double at_m = first_m; at_m <= last_m; at_m += ground::kCoverSample_m, ++samples)
    covered += is_covered(tunnel, ribs, at_m, heights);
  return covered >= ground::kMinCoveredShare * samples;
}

GeneratedStructure generate_tunnel(const Span& tunnel, double tolerance_m) {
  assert(tolerance_m > 0);
  GeneratedStructure generated;
  const std::vector<Rib> all = ribs_of(tunnel);
  if (all.empty() || !tunnel.is_bored) return generated;
  const DeckDimensions dimensions = deck_dimensions(tunnel, 0);
  // half of the tolerance is for ribs, half for frames and kerbs
  const SimplifiedRibs simplified = simplify_ribs(all, dimensions.left_m, dimensions.right_m, tolerance_m / 2);
  const bool has_kerbs = has_detail(Detail::kRoadSurfaces, tolerance_m), has_frames = tolerance_m / 2 < kFrameTop_m;
  const Section road = add_road(tunnel, simplified.ribs, has_kerbs, tolerance_m, generated);
  const double high_m = ground::bore_height_m(tunnel);
  Mesh mesh = lining(tunnel, simplified.ribs, road, high_m);
  if (has_frames && is_on_ground(tunnel.from)) add_frame(simplified.ribs.front(), -1, road, high_m, mesh);
  if (has_frames && is_on_ground(tunnel.to)) add_frame(simplified.ribs.back(), 1, road, high_m, mesh);
  add_tunnel_concrete(std::move(mesh), tunnel, generated);
  generated.error_m = simplified.error_m + std::max(has_kerbs ? 0 : ground::kKerbRise_m, has_frames ? 0 : kFrameTop_m);
  return generated;
}

}  // namespace citykiln::structures
