#include "compiler/assume/surfaces.h"

#include "compiler/assume/beside.h"
#include "compiler/assume/cut_way.h"
#include "compiler/assume/pavements.h"

namespace citykiln::assume {
namespace {

struct UnpavedRow {
  map::LandCoverClass paved, unpaved;
  LandUse land;
};
constexpr UnpavedRow kUnpavedRows[] = {
#define UNPAVED(paved, unpaved, land) {map::LandCoverClass::paved, map::LandCoverClass::unpaved, LandUse::land},
#include "compiler/assume/surfaces.inc"
#undef UNPAVED
};

bool may_be_unpaved(const map::Track& track) {
  if (track.has_tagged_surface || track.passage != map::Passage::kGround || track.is_rail || track.is_indoor)
    return false;
  if (track.is_through_building) return false;
  for (const UnpavedRow& row : kUnpavedRows)
    if (row.paved == track.surface) return true;
  return false;
}

// Returns the class that surface=gravel gives a way of this class, if surfaces.inc says that it is unpaved in this land
// use; else `way_class`.
map::LandCoverClass assumed_surface(map::LandCoverClass way_class, LandUse land) {
  for (const UnpavedRow& row : kUnpavedRows)
    if (row.paved == way_class && row.land == land) return row.unpaved;
  return way_class;
}

}  // namespace

std::vector<map::Track> assume_surfaces(const map::FeatureView& features, Report& report) {
  const Surroundings surroundings = index_surroundings(features);
  const CommonNodes common = common_nodes_of(features.tracks);
  const auto cut = [&](const map::Track& track) {
    const bool may_be_cut = may_be_unpaved(track) && !track.is_piece;
    return may_be_cut ? cut_way(track, kLongestWhole_m, kStretch_m, common) : std::vector{track};
  };
  const auto change = [&](map::Track& stretch) {
    if (!may_be_unpaved(stretch) || length_m(stretch.axis) > kLongestWhole_m) return false;
    const map::LandCoverClass before = stretch.surface;
    stretch.surface = assumed_surface(before, land_use_along(surroundings, stretch.axis));
    return stretch.surface != before;
  };
  return with_changed_stretches(features.tracks, Assumption::kSurfaces, "surface_track", cut, change, report);
}

}  // namespace citykiln::assume
