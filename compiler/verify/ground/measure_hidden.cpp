#include "compiler/verify/ground/measure_hidden.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/derived_id.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;

constexpr int kPlacesASide = 12, kLeastPlaces = 4;
constexpr double kLarger = 1.05, kTrackStep_m = 4;

bool is_mapped_area(const ground::LandCoverPolygon& surface) {
  const LandCoverGroup group = map::values_of(surface.surface).group;
  return surface.surface != LandCoverClass::kUnknown && !ground::is_yard(surface) && !is_of_field(surface.id) &&
         surface.piece == 0 && surface.area_m2 > ground::kPassedJunctionArea_m2 && group != LandCoverGroup::kRoad &&
         group != LandCoverGroup::kPath && group != LandCoverGroup::kRail && group != LandCoverGroup::kBuilding;
}

// The polygon that is on top at every place of an area; kNoLandCover if several are, or there are too few places.
std::uint32_t only_one_on_top(const ground::LandCoverIndex& land_cover, const ground::LandCoverPolygon& area) {
  const Box2 box = ground::box_of(area);
  std::uint32_t only = ground::kNoLandCover;
  int places = 0;
  for (int i = 0; i < kPlacesASide * kPlacesASide; ++i) {
    const Vec2 share{(i % kPlacesASide + 0.5) / kPlacesASide, (i / kPlacesASide + 0.5) / kPlacesASide};
    const Vec2 p{box.min.x + share.x * box.width(), box.min.y + share.y * box.height()};
    if (ground::winding_number(area, p) <= 0) continue;
    const std::uint32_t top = ground::land_cover_at(land_cover, p);
    if (places++ > 0 && top != only) return ground::kNoLandCover;
    only = top;
  }
  return places >= kLeastPlaces ? only : ground::kNoLandCover;
}

// Adds the places of a track; `below_m` is the length of carriageway so far.
void test_track(const roads::Road& track, const ground::LandCoverIndex& land_cover, const Box2& box,
                HiddenThings& found) {
  double below_m = 0;
  for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
    const Vec2 a = track.axis[i], b = track.axis[i + 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kTrackStep_m)));
    for (int k = 0; k < steps; ++k) {
      const Vec2 p = a + (b - a) * ((k + 0.5) / steps);
      if (!box.contains(p)) continue;
      ++found.tests;
      const std::uint32_t top = ground::land_cover_at(land_cover, p);
      const bool is_below = top != ground::kNoLandCover &&
                            map::values_of(land_cover.surfaces[top].surface).group == LandCoverGroup::kRoad &&
                            land_cover.surfaces[top].id.osm != track.id.osm;
      below_m = is_below ? below_m + distance(a, b) / steps : 0;
      if (below_m <= kLongestBoards_m) continue;
      if (found.hidden++ == 0)
        found.at = p, found.element = track.id.osm, found.on_top = land_cover.surfaces[top].id.osm;
    }
  }
}

}  // namespace

HiddenThings measure_hidden_areas(const ground::LandCoverIndex& land_cover, const Box2& box) {
  HiddenThings found;
  for (const ground::LandCoverPolygon& area : land_cover.surfaces) {
    const Box2 own = ground::box_of(area);
    if (!is_mapped_area(area) || own.is_empty() || !box.contains(own.min) || !box.contains(own.max)) continue;
    ++found.tests;
    const std::uint32_t top = only_one_on_top(land_cover, area);
    if (top == ground::kNoLandCover) continue;
    const ground::LandCoverPolygon& on_top = land_cover.surfaces[top];
    if (&on_top == &area || !is_mapped_area(on_top) || on_top.area_m2 < kLarger * area.area_m2) continue;
    if (found.hidden++ == 0) found.at = own.centre(), found.element = area.id.osm, found.on_top = on_top.id.osm;
  }
  return found;
}

HiddenThings measure_hidden_tracks(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                   const Box2& box) {
  HiddenThings found;
  for (const roads::Road& road : chunk.roads)
    if (map::values_of(road.surface).group == LandCoverGroup::kRail) test_track(road, land_cover, box, found);
  return found;
}

}  // namespace citykiln::verify
