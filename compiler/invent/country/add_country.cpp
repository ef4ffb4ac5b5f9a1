#include "compiler/invent/country/add_country.h"

#include "compiler/invent/country/add_fields.h"
#include "compiler/invent/country/add_tracks.h"
#include "compiler/invent/country/add_wild_cover.h"
#include "compiler/invent/country/taken_land.h"

namespace citykiln::invent {

void add_country(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
                 InventedMap& map) {
  add_tracks(terrain, settings, side_m, seed, map);
  TakenLand taken = taken_land_of(map, terrain, true);
  taken.index();
  add_wild_cover(terrain, settings, side_m, seed, taken, map);
  if (settings.has_fields) add_fields(terrain, settings, side_m, seed, taken, map);
}

}  // namespace citykiln::invent
