// Draws a yard from its recipe: areas, the openings of its border, barriers and plants.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/lots/mapped_things.h"
#include "compiler/lots/recipe.h"
#include "compiler/lots/yard_rules.h"
#include "compiler/map/features.h"

namespace citykiln::lots {

/// The widths of paths and drives: usual slabs for one person, and the lane of a garage (GaStellV: 2.75 m).
inline constexpr double kYardPath_m = 1.25, kDriveWidth_m = 2.75;
/// Front yards narrower than this are not seen beside the pavement.
inline constexpr double kLeastSeen_m = 0.3125;
/// Barriers along a street stand this far inside the pavement's outer edge.
inline constexpr double kInsidePavement_m = 0.375;

/// Returns the middle lines of path and drive with half their widths, in the plane.
std::vector<Capsule> openings_of(const Yard& yard);

/// A step of a border: a piece of an edge of the lot's outer ring, of at most 0.5 m.
struct BorderStep {
  Vec2 from, to;
  std::uint32_t edge = 0;  ///< The edge from this point of the ring to the next one.
};
/// Returns the steps around a ring, from its first point on. Each edge is divided evenly. O(length).
std::vector<BorderStep> border_steps(const Ring& ring);

/// Returns how far a barrier of a run stands inside the ring.
double inset_m(BorderPlace place);
/// Returns the axis of the barrier along a run of steps, moved into the ring. Points are multiples of map::kMapStep_m.
/// @param steps  The border_steps() of the ring. `run` has at least one step, and no more than the ring has.
Polyline border_line(std::span<const BorderStep> steps, const BorderRun& run);

/// A plant of a yard.
struct YardPlant {
  Vec2 at;  ///< A multiple of kYardStep_m.
  bool is_shrub = false;
  double height_m = 0;  ///< A multiple of kYardStep_m; 0: as usual for its species.
};

/// Returns the plants that the seed draws on the soft ground of a yard, whatever else stands there: at most one in each
/// square of 4 m of a grid of the plane, moved at random by up to 1.2 m, so that two are at least 1.4 m apart; with the
/// rule's density; 0.75 m or more inside the border. In the order of squares, row by row from the south.
std::vector<YardPlant> plants_drawn(const Yard& yard, const YardRule& rule, std::uint64_t seed);

/// The name that rows of bays have in pitches/pitches.inc.
inline constexpr const char* kBays = "parking";

/// The features of a yard. Each has the id of the building, with a part from kFirstDerivedPart on
/// (contract/derived_id.h); ids are unique within one list.
struct DrawnYard {
  std::vector<map::AreaFeature> areas;  ///< The rear covers the whole lot, and the others lie on top of it.
  std::vector<map::SportsArea> bays;    ///< With the ids of areas.
  std::vector<map::Barrier> barriers;
  std::vector<map::PointFeature> plants;
};

/// Returns the features of a yard; none if no rule fits. Depends on nothing else, so that a yard can be drawn again
/// from a manifest. Accepts any yard; runs, plants and barriers that do not exist are left out. Cost: O(area of its
/// box).
DrawnYard draw_yard(const Yard& yard, std::uint64_t seed);

}  // namespace citykiln::lots
