#include "compiler/verify/standing/measure_things.h"

#include <set>

#include "compiler/map/things/thing_role.h"
#include "compiler/verify/standing/taken_land.h"

namespace citykiln::verify {
StandingThings measure_things(const bake::BakedTile& tile, const scene::Chunk& chunk,
                              const ground::LandCoverIndex& land_cover) {
  std::set<OsmId> tested;
  for (const things::Thing& thing : chunk.things)
    if (!thing.is_in_way && !map::is_contact(map::role_of(thing.form.kind))) tested.insert(thing.id.osm);
  StandingThings found;
  for (const bake::InstancedMesh& instanced : tile.instanced)
    for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
      const OsmId id = tile.features[instanced.features[i]];
      if (!tested.contains(id)) continue;
      const bake::Float3& offset = instanced.translations[i];
      const Vec2 at = in_plan(Vec3{offset[0], offset[1], offset[2]} + tile.origin);
      ++found.tested;
      if (taken_land_at(land_cover, at) == nullptr) continue;
      if (found.conflicts++ == 0) found.at = at, found.element = id;
    }
  return found;
}

}  // namespace citykiln::verify
