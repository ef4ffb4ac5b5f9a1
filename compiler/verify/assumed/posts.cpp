#include <set>
#include <vector>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/props/luminaire.h"
#include "compiler/things/facing.h"
#include "compiler/verify/assumed/measure_assumed.h"
#include "compiler/verify/standing/taken_land.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;
using roads::Road;

std::set<OsmId> ways_with_assumed_lamps(const scene::Chunk& chunk) {
  std::set<OsmId> ways;
  const auto add = [&](const auto& all) {
    for (const Road& road : all)
      if (has(road.assumed, Assumption::kLamps)) ways.insert(road.id.osm);
  };
  add(chunk.roads), add(chunk.bridges), add(chunk.tunnels);
  return ways;
}

// The places where an assumed mast stands on the ground; none for other things.
std::vector<Vec2> feet_of(const things::Thing& thing) {
  const map::ThingRole role = map::role_of(thing.form.kind);
  if (!is_derived(thing.id) || !map::is_contact(role) || role == map::ThingRole::kContactHanger) return {};
  if (role != map::ThingRole::kContactPortal) return {thing.at};
  const Vec2 half = left_of(things::unit_vector(thing.direction)) * (thing.form.width_m / 2);
  return {thing.at + half, thing.at - half};
}

// The clear space beside a track: 2.5 m of a railway, 1.65 m of a tramway, and what half a mast is at least.
constexpr double kClearOfRailway_m = 2.6, kClearOfTramway_m = 1.75;

OsmId track_too_near(const scene::Chunk& chunk, Vec2 p) {
  for (const Road& road : chunk.roads) {
    if (map::values_of(road.surface).group != map::LandCoverGroup::kRail) continue;
    const double clear_m = road.surface == LandCoverClass::kTram || road.surface == LandCoverClass::kStreetRails
                               ? kClearOfTramway_m
                               : kClearOfRailway_m;
    if (distance_to_polyline(road.axis, p) < clear_m) return road.id.osm;
  }
  return {};
}

}  // namespace

AssumedTests measure_assumed_lamps(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                   const ground::LandCoverIndex& land_cover) {
  AssumedTests found;
  const std::set<OsmId> ways = ways_with_assumed_lamps(chunk);
  if (ways.empty()) return found;
  for (const bake::InstancedMesh& instanced : tile.instanced) {
    if (!props::lamp_named(instanced.name)) continue;
    for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
      const OsmId way = tile.features[instanced.features[i]];
      if (!ways.contains(way)) continue;
      const bake::Float3& offset = instanced.translations[i];
      const Vec2 at = in_plan(Vec3{offset[0], offset[1], offset[2]} + tile.origin);
      const OsmId on = taken_element_at(land_cover, at);
      ++found.tested;
      if (on.type == OsmType::kNone) continue;
      if (found.conflicts++ == 0) found.at = at, found.element = way, found.obstacle = on;
    }
  }
  return found;
}

AssumedTests measure_assumed_masts(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                   const Box2& box) {
  AssumedTests found;
  for (const things::Thing& mast : chunk.things)
    for (const Vec2 foot : feet_of(mast)) {
      if (!box.contains(foot)) continue;
      ++found.tested;
      OsmId on = taken_element_at(land_cover, foot);
      if (on.type == OsmType::kNone) on = track_too_near(chunk, foot);
      if (on.type == OsmType::kNone) continue;
      if (found.conflicts++ == 0) found.at = foot, found.element = mast.id.osm, found.obstacle = on;
    }
  return found;
}

}  // namespace citykiln::verify
