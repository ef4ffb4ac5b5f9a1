#include "compiler/ground/cover/strip_cover.h"

#include <cassert>

namespace citykiln::ground {

// the area is a constant: a trimmed strip must rank as the whole one, so among equals the id decides
LandCoverPolygon surface_of(const roads::Strip& stream) {
  return {.id = stream.id,
          .surface = stream.surface,
          .area_m2 = kStripArea_m2,
          .rings = roads::stroke(stream, {true, {}, {}})};
}

LandCoverPolygon surface_of(const roads::Road& road, const roads::StripEnds& ends) {
  return {.id = road.id,
          .surface = road.surface,
          .area_m2 = kStripArea_m2,
          .rings = roads::stroke_carriageway(road, ends),
          .is_graded = !road.profile.empty()};
}

LandCoverPolygon pavement_of(const roads::Road& road, const roads::StripEnds& ends) {
  return {.id = road.id,
          .surface = map::LandCoverClass::kPavement,
          .area_m2 = kStripArea_m2,
          .rings = roads::stroke_pavements(road, ends)};
}

LandCoverPolygon trimmed_to(const LandCoverPolygon& surface, const Box2& box) {
  assert(!box.is_empty());
  LandCoverPolygon trimmed{.id = surface.id,
                           .surface = surface.surface,
                           .area_m2 = surface.area_m2,
                           .rings = {},
                           .piece = surface.piece,
                           .level_m = surface.level_m,
                           .is_graded = surface.is_graded,
                           .raised_priority = surface.raised_priority,
                           .row_heading = surface.row_heading};
  for (const Ring& ring : surface.rings)
    if (Ring kept = citykiln::trimmed_to(ring, box); !kept.empty()) trimmed.rings.push_back(std::move(kept));
  return trimmed;
}

}  // namespace citykiln::ground
