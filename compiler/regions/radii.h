// The radius of influence of each stage: how far from a tile data can change the tile. A region is compiled from the
// data within kRegionHalo_m of it, which is at least the sum of the radii along the longest chain of stages that depend
// on each other, not of all radii. Stages that are not listed (styles, tags, random draws) look at one object alone.
#pragma once

#include "compiler/assume/bridge_pavements.h"
#include "compiler/assume/curves/curves.h"
#include "compiler/assume/fit_widths.h"
#include "compiler/assume/fronts.h"
#include "compiler/assume/heights.h"
#include "compiler/assume/pavements.h"
#include "compiler/fields/divide_land.h"
#include "compiler/ground/correction/corrected_land.h"
#include "compiler/ground/levelling/airports.h"
#include "compiler/ground/profiles/graph/approach_paths.h"
#include "compiler/ground/profiles/graph/profile_graph.h"
#include "compiler/ground/profiles/plan_profiles.h"
#include "compiler/ground/profiles/smoothing/initial_heights.h"
#include "compiler/ground/water/river_areas.h"
#include "compiler/lots/add_yards.h"
#include "compiler/map/lanes/transitions.h"
#include "compiler/plants/placing/blue_noise.h"
#include "compiler/plants/placing/placing.h"
#include "compiler/plants/recipe.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/pieces/stretches.h"
#include "compiler/scene/scene.h"
#include "compiler/things/contact_masts.h"
#include "compiler/things/railings.h"
#include "compiler/wires/plan.h"

namespace citykiln::regions {

// | stage                  | constant                       | metres | data at that distance                          |
// |------------------------|--------------------------------|-------:|------------------------------------------------|
// | chunk of a tile        | scene::kHalo_m                 |     48 | ground, footprints, woods around the tile      |
// | woods                  | plants::kInfluenceRadius_m     |     48 | candidates of blue noise; within kHalo_m       |
// | plants' obstacles      | plants::kObstacleInfluence_m   |     16 | hedges, rows, corridors                        |
// | roads of a chunk       | scene::kRoadHalo_m             |     56 | arms of the junctions of the tile              |
// | junctions              | roads::kJunctionRadius_m       |     24 | nodes that are one junction                    |
// | pieces of roads        | roads::kJunctionHalo_m         |     32 | junctions that end a stretch                   |
// | running water          | ground::kMaxInfluence_m        |   1008 | the axis that gives a bank its height          |
// | transitions of lanes   | map::kLongestTransition_m      |    512 | the ways before and after                      |
// | assumed widths         | assume::kLongestFitted_m       |    512 | objects that are mapped beside the way         |
// | assumed pavements      | assume::kPavementRadius_m      |    576 | houses beside the other end of the way         |
// | curved axes            | assume::kCurveRadius_m         |    544 | chords before and after, houses about them     |
// | verges, parking        | assume::kPavementRadius_m      |    576 | the same, beside the same stretch              |
// | closed frontages       | assume::kPavementRadius_m      |    576 | houses and footways beside the same stretch    |
// | assumed surfaces       | assume::kPavementRadius_m      |    576 | land use along the way                         |
// | pavements on bridges   | assume::kLongestBridge_m       |    128 | streets at the other end                       |
// | assumed storeys        | assume::kHeightNeighbours_m    |    200 | buildings with tagged heights                  |
// | assumed roofs          | assume::kHeightRow_m           |     64 | the house that draws for its row               |
// | assumed fronts         | assume::kFrontSearch_m         |    150 | mapped shops                                   |
// | profiles               | ground::kProfileRadius_m       |   2560 | smoothing, junction planes, limits of grade    |
// | bridges and tunnels    | ground::kSpanEndRadius_m       |   4096 | their ends                                     |
// | storeys of bridges     | kStoreyRadius_m                |   1700 | two ramps of a railway that crosses a bridge   |
// | paths to a bridge      | ground::kLongestApproach_m     |   2048 | a bridge or tunnel that moves the path         |
// | ends of these paths    | ground::kApproach_m            |     32 | the end of a bridge or tunnel                  |
// | knots of profiles      | ground::kKnotStretch_m         |   1024 | heights along the same way                     |
// | corrected land         | kCorrectedLand_m               |   1152 | roads that correct samples of the heightmap    |
// | airports               | ground::kMostAirportBank_m     |    512 | runways, taxiways, aprons; and those they join |
// | assumed yards          | lots::kYardRadius_m            |    768 | buildings and streets about the lots beside    |
// | assumed fields         | fields::kFieldRadius_m         |   3584 | land and lines about the same field            |
// | houses of filled lots  | parcels::kInfluenceRadius_m    |    512 | buildings and streets about the lot            |
// | assumed railings       | things::kRailingRadius_m       |     72 | barriers, ways and heights beside the edge     |
// | assumed contact lines  | things::kContactRadius_m       |    384 | tracks beside those at the other support       |
// | wires                  | wires::kSpanRadius_m           |    512 | a support, and the ground that it stands on    |
//
// A storey is one level of bridges or tunnels above each other: a bridge over a bridge is the second. A junction plane
// is the common plane of the roads at a junction. A knot is a point of a profile of heights; between knots the profile
// is straight.
//
// Curves depend on what is mapped and on the width of their own road, so kAssumedRoads_m holds them too.
// A way has either a transition of lanes or a fitted width, so their radii do not add up. Assumed pavements depend on
// the kerbs of the streets beside them, which are fitted before. Storeys, roofs and fronts change buildings alone.
// Yards lie beside the roads of kAssumedRoads_m, and about the houses that fill lots.
//
// Some facts have no radius and are therefore found by the survey of the whole extent: coastlines, levels of standing
// water, profiles of running water, and the heights that fill places without a heightmap. The header's fields also come
// from the survey, except rules and species: a region lists those that it uses.

/// The radius of one storey of bridges: two ramps of 850 m, as a railway needs (plan_profiles.h).
inline constexpr double kStoreyRadius_m = 1700;

/// The radius of what is assumed of a road: the fitted widths of the streets beside it, its pavements, then those of a
/// bridge.
inline constexpr double kAssumedRoads_m =
    assume::kLongestFitted_m + assume::kPavementRadius_m + assume::kLongestBridge_m;

/// The radius of the land that roads correct: ground::kCorrectionSteps of the longest steps of samples
/// (map::resample()).
inline constexpr double kCorrectedLand_m = ground::kCorrectionSteps * map::kCell_m;

/// The width of the data around a region that it is compiled with: at least the sum of radii along the longest chain of
/// dependences, which is a tile, the supports of its wires, the roads and junctions that grade and correct the ground
/// below these, their profiles, the bridges of these, and the bridges that cross them. A whole number of cells of 128
/// m.
inline constexpr double kRegionHalo_m = 12416;

static_assert(kRegionHalo_m >= wires::kSpanRadius_m + scene::kHalo_m + scene::kRoadHalo_m + roads::kJunctionRadius_m +
                                   kAssumedRoads_m + ground::kProfileRadius_m + ground::kSpanEndRadius_m +
                                   kStoreyRadius_m + ground::kKnotStretch_m + kCorrectedLand_m);
static_assert(kRegionHalo_m >= scene::kHalo_m + scene::kRoadHalo_m + roads::kJunctionRadius_m + kAssumedRoads_m +
                                   ground::kLongestApproach_m + ground::kApproach_m + ground::kProfileRadius_m +
                                   ground::kSpanEndRadius_m + kCorrectedLand_m);
// what is assumed by heights takes the place of wires in this chain
static_assert(things::kRailingRadius_m <= wires::kSpanRadius_m && things::kContactRadius_m <= wires::kSpanRadius_m);
// yards change surfaces, barriers, plants and doors, not heights of roads
static_assert(kRegionHalo_m >= scene::kHalo_m + plants::kObstacleInfluence_m + lots::kYardRadius_m +
                                   parcels::kInfluenceRadius_m + roads::kJunctionRadius_m + kAssumedRoads_m);
static_assert(kRegionHalo_m >=
              scene::kHalo_m + plants::kObstacleInfluence_m + fields::kFieldRadius_m + kAssumedRoads_m);
/// The additional width where houses fill lots: pavements and verges then depend on these houses, and the houses on the
/// streets about their lots. A whole number of cells of 128 m.
inline constexpr double kFilledLotsHalo_m = 1792;
static_assert(kFilledLotsHalo_m >= parcels::kInfluenceRadius_m + roads::kJunctionRadius_m + kAssumedRoads_m);

static_assert(assume::kCurveRadius_m <= kAssumedRoads_m);
static_assert(map::kLongestTransition_m <= assume::kLongestFitted_m);
static_assert(kRegionHalo_m >= scene::kHalo_m + ground::kMaxInfluence_m + plants::kInfluenceRadius_m);

}  // namespace citykiln::regions
