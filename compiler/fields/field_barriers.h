// Hedges and walls on the borders of fields.
#pragma once

#include <functional>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/fields/divide_land.h"
#include "compiler/lots/mapped_things.h"
#include "compiler/map/features.h"

namespace citykiln::fields {

struct FieldInputs;

/// Finds the places where nothing mapped keeps a hedge or wall from standing.
class BarrierPlaces {
 public:
  /// Builds indexes of the features, roads and junctions, which must outlive this object.
  /// O(n log n).
  BarrierPlaces(const map::FeatureView& features, const FieldInputs& inputs);

  /// True if a place is at least kClear_m from ways, junctions, water, buildings, barriers and
  /// trees, and if no area of another use than farming lies above `land` there: one that is smaller
  /// or has a higher priority. Unmapped land must be kFromHouses_m from buildings, since gardens of
  /// towns have no hedges of fields. O(things near).
  bool is_free(Vec2 at, const map::AreaFeature& land) const;

  /// True if a hedge beside a road may stand at a place: at least kOffLane_m from the edges of all
  /// ways, pavements included, kFromHouses_m from buildings, kClear_m from junctions, water,
  /// barriers and trees, and on no area of another use than farming. O(things near).
  bool is_beside_lane(Vec2 at) const;

 private:
  bool is_on_other_land(Vec2 at, const map::AreaFeature& land) const;
  lots::MappedThings mapped_;
  lots::Capsules waters_;
  std::vector<const map::AreaFeature*> areas_;
  BoxGrid areas_grid_;
};

/// Returns true if nothing keeps a hedge or wall from standing at a place, in plane metres.
using IsFree = std::function<bool(Vec2)>;

/// Returns the hedges or walls on a border of fields, each over a stretch of at least
/// kShortestBarrier_m where is_free(), with a random height. is_free() is called every 3 m or less. An
/// opening of kGate_m for machines has its middle at 40 to 60 % of the border. Ids are those of field_id(), from
/// line.number on. O(length of the border).
/// @param land  The id of the area that the border divides.
/// @param draw  A sequence of this border; draws 1 and 2 are used.
std::vector<map::Barrier> barriers_on(const FieldBoundary& line, FieldBorder border, ObjectId land,
                                      const IsFree& is_free, const RandomSequence& draw);

/// The least distance in metres of a hedge beside a road from the edges of ways, and from
/// buildings.
inline constexpr double kOffLane_m = 1.25, kFromHouses_m = 30;

/// The shortest hedge or wall, and the width of the opening, in metres.
inline constexpr double kShortestBarrier_m = 12, kGate_m = 5;

}  // namespace citykiln::fields
