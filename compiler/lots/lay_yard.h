// Lays the path of a yard from the door to the street, its drive, and its bays.
#pragma once

#include <vector>

#include "compiler/lots/mapped_things.h"
#include "compiler/lots/plan_lots.h"
#include "compiler/lots/yard_rules.h"

namespace citykiln::lots {

/// The path and the drive of a yard, as pieces, and whether it has bays.
struct YardLayout {
  std::vector<YardStrip> strips;
  bool has_bays = false;
};

/// Returns the path and the drive of a lot's yard, the path first, and whether its front has bays.
///
/// - bays: in front of shops and works, if there is room for a row and its lane (11 m), and no car park is mapped in or
///   beside the lot;
/// - a path: from the door at a right angle to its wall, then to the street; none without a door, with a mapped path in
///   the lot, or if the front is less than 0.75 m deep;
/// - a drive, if the rule has one: to a garage, else past the house at the side with more room, else in front of it if
/// a
///   car has room; none if a drive or a car park is mapped in the lot or within 1 m of it.
///
/// Neither path nor drive is laid where it would leave the lot or meet a wall or a mapped barrier, tree or pool.
/// O(things near).
YardLayout lay_yard(const map::FeatureView& features, const Lot& lot, const YardRule& rule, const MappedThings& mapped);

}  // namespace citykiln::lots
