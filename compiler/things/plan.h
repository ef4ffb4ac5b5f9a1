// Plans things: finds a place and a direction for each mapped thing.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/findings/report.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"
#include "compiler/things/catalogue.h"
#include "compiler/things/contact_masts.h"
#include "compiler/things/railings.h"
#include "compiler/things/recipe.h"

namespace citykiln::things {

/// All things of a map, and what other rooms hang on them or stand beside them.
struct ThingPlan {
  Kinds kinds;                            ///< The kinds of `things` and `beyond`.
  std::vector<map::ThingFeature> mapped;  ///< The mapped things and the equipment of pitches, without replaced masts.
  std::vector<Thing> things;              ///< Sorted by id, then by place.
  std::vector<Thing> beyond;              ///< Supports of power lines outside of the extent, sorted by id.
  ContactLines contact_lines;             ///< Its masts are among `things`.
  std::vector<props::Barrier> railings;   ///< With guard rails. Sorted by id, then axis.
};

/// The data that things depend on, besides the map.
struct ThingInputs {
  const Catalogue& catalogue;
  std::span<const map::ThingFeature> equipment;     ///< The equipment of pitches.
  std::span<const ground::LandCoverPolygon> cover;  ///< The land cover of the whole map, with buildings.
  std::span<const roads::Road> roads;               ///< On the ground; must outlive the result.
  std::span<const roads::Junction> junctions;
  std::span<const structures::Span> bridges;  ///< Must outlive the result.
  std::span<const buildings::Building> buildings;
  const ground::GradedTerrain& ground;
  Assumptions assumed = kNoAssumptions;
  std::uint64_t seed = 0;
};

/// Plans railings, contact lines and things, in this order. Errors: those of kinds_of().
Result<ThingPlan> plan(const map::FeatureView& features, const ThingInputs& inputs, Report& report);

/// Returns the names of the kinds of a map's things, and that of cars if the table has it.
std::set<std::string> kind_names(const map::FeatureView& features, const map::ThingTable& table);

/// Returns the things of a map, sorted by id. A thing that may not stand where it is mapped is moved to a free place
/// (free_places.h), or dropped, kNoPlaceForThing, and kOutsideBounds if the place is outside of the extent. Signals of
/// a junction stand at its arms (junction_signals.h). Mapped parking spaces are things of the role
/// map::ThingRole::kCar, without a form. Things that may stand on buildings stay where they are mapped on one
/// (on_roofs.h); a thing that is tagged to be on a roof, and is on none, is dropped, kAboveGround. Ledger
/// "things/thing". O(things · land cover and buildings near them).
/// @param cover  The land cover of the whole map, with buildings.
/// @param kinds  The kinds of all things of the map; see kinds_of().
std::vector<Thing> plan_mapped(const map::FeatureView& features, std::span<const roads::Road> roads,
                               std::span<const roads::Junction> junctions,
                               std::span<const ground::LandCoverPolygon> cover,
                               std::span<const buildings::Building> buildings, const Kinds& kinds, std::uint64_t seed,
                               Report& report);

/// Returns the supports of power lines outside of the extent, where they are mapped. Sorted by id. They are not built.
/// @param kinds  The kinds of the map's things.
std::vector<Thing> plan_supports_beyond(const map::FeatureView& features, const Kinds& kinds, std::uint64_t seed);

}  // namespace citykiln::things
