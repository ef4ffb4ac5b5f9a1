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

/// Finds the places on which nothing mapped keeps a hedge from standing.
class BarrierPlaces {
 public:
  /// Refers to the features, which must outlive it. O(n log n).
  BarrierPlaces(const map::FeatureView& features, const FieldInputs& inputs);

  /// True if a place is kClear_m from ways, water, buildings, barriers and trees, and no smaller area of another use
  /// than farming lies on it. O(things near).
  bool is_free(Vec2 at, const map::AreaFeature& land) const;

  /// True if a place is outside of towns and free for a hedge beside a road: kOffLane_m from other ways, and
  /// kFromHouses_m from buildings. O(things near).
  bool is_beside_lane(Vec2 at) const;

 private:
  bool is_on_other_land(Vec2 at, const map::AreaFeature& land) const;
  lots::MappedThings mapped_;
  lots::Capsules waters_;
  std::vector<const map::AreaFeature*> areas_;
  BoxGrid areas_grid_;
};

/// Returns true if a hedge may stand at a place.
using IsFree = std::function<bool(Vec2)>;

/// Returns the hedges or walls on a border of land with this id, each on a free stretch of kShortestBarrier_m or more,
/// with an opening for machines in the middle. Ids are of field_id(), unique for borders of different numbers but by
/// chance. Asks for places every 3 m.
std::vector<map::Barrier> barriers_on(const FieldLine& line, FieldBorder border, ObjectId land, const IsFree& is_free,
                                      const RandomSequence& draw);

/// The distance of a hedge beside a road from the edge of ways, and from buildings, in metres.
inline constexpr double kOffLane_m = 1.25, kFromHouses_m = 30;

/// The shortest hedge or wall, and the width of an opening for machines, in metres.
inline constexpr double kShortestBarrier_m = 12, kGate_m = 5;

}  // namespace citykiln::fields
