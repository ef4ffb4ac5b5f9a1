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

/// Returns the path and the drive of a lot's yard, and whether its front has bays.
///
/// In front of shops and works there are bays for cars, if there is room for a row and its lane.
/// A path goes from the door square to its wall, then to the street. A drive leads to a garage, else past the house at
/// the side with room, else in front of it if a car has room. Neither is laid where it would leave the lot, meet a
/// wall or a mapped barrier, tree or pool; nor a path where a path is mapped in the lot; nor a drive where a drive or
/// a car park is mapped in or beside the lot.
YardLayout lay_yard(const map::FeatureView& features, const Lot& lot, const YardRule& rule, const MappedThings& mapped);

}  // namespace citykiln::lots
