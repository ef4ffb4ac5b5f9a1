#include "compiler/bake/place_people.h"

#include "compiler/bake/ground_on_top.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/people/people.h"
#include "compiler/things/facing.h"

namespace citykiln::bake {
namespace {

constexpr double kLampFoot_m = 0.25;

people::Solid solid_of(const things::Form& form, Vec2 at, Vec2 right, OsmId feature) {
  return {.at = at,
          .right = right,
          .width_m = form.width_m,
          .depth_m = form.depth_m,
          .is_seat = form.kind == "bench",
          .is_stop = form.kind == "bus_stop" || form.kind == "tram_stop",
          .feature = feature};
}

std::vector<people::Solid> solids_of(const scene::Chunk& chunk, std::span<const PlacedThing> furniture,
                                     const Lamps& lamps) {
  std::vector<people::Solid> solids;
  for (const things::Thing& thing : chunk.things)
    if (!thing.foot_m && map::role_of(thing.form.kind) != map::ThingRole::kCar)
      solids.push_back(solid_of(thing.form, thing.at, left_of(things::unit_vector(thing.direction)), thing.id.osm));
  for (const PlacedThing& piece : furniture)
    solids.push_back(solid_of(piece.form, in_plan(piece.placement.at),
                              {piece.placement.cos_yaw, piece.placement.sin_yaw}, piece.placement.feature));
  for (const props::StreetLamp& lamp : lamps.standing)
    solids.push_back({.at = lamp.at, .right = {1, 0}, .width_m = kLampFoot_m, .depth_m = kLampFoot_m});
  return solids;
}

people::PeopleWish wish_of(const scene::Header& header) {
  const std::uint8_t month = climate::equivalent_month(header.climate.origin_class, scene::local_month_of(header));
  return {.share = header.people,
          .time = scene::week_time_of(header),
          .season = people::season_of(month),
          .country = map::country_group_at(header.origin),
          .seed = header.seed,
          .tile_m = header.tile_m};
}

}  // namespace

std::vector<PlacedThing> place_people(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const PlacedThing> furniture, const TileGround& ground,
                                      const Box2& box) {
  if (!people::has_people(header.people)) return {};
  const std::vector<people::Solid> solids = solids_of(chunk, furniture, ground.lamps);
  const people::StreetLife life{.roads = chunk.roads,
                                .junctions = chunk.junctions,
                                .buildings = chunk.buildings,
                                .trunks = ground.trunks,
                                .barriers = chunk.barriers,
                                .solids = solids,
                                .land_cover = ground.land_cover};
  std::vector<PlacedThing> placed;
  for (const things::Thing& person : people::people_in(life, wish_of(header), box)) {
    const Vec2 right = left_of(things::unit_vector(person.direction));
    // the mesh faces -y
    placed.push_back({.form = person.form,
                      .placement = {.at = at_height(person.at, snapped(ground_on_top_m(ground.land_cover, ground.graded,
                                                                                       person.at))),
                                    .cos_yaw = right.x,
                                    .sin_yaw = right.y,
                                    .feature = person.id.osm},
                      .source = ThingSource::kPerson});
  }
  return placed;
}

}  // namespace citykiln::bake
