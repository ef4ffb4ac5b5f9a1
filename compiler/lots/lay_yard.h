// Lays the ground of a yard: its surfaces, the path from the door to the street, and the drive.
#pragma once

#include <optional>
#include <vector>

#include "compiler/lots/mapped_things.h"
#include "compiler/lots/plan_lots.h"
#include "compiler/lots/yard_rules.h"

namespace citykiln::lots {

/// A polygon of a yard.
struct YardArea {
  map::LandCoverClass surface{};
  Polygon polygon;        ///< Snapped.
  bool has_bays = false;  ///< Bays for cars are painted on it.
};

/// The ground of a yard.
struct YardGround {
  std::vector<YardArea> areas;    ///< The rear covers the whole lot, and the others lie on top of it.
  std::vector<Capsule> openings;  ///< Path and drive, as borders keep clear of them.
  bool has_path = false, has_drive = false;
};

/// The widths of paths and drives: usual slabs for one person, and the lane of a garage (GaStellV: 2.75 m).
inline constexpr double kYardPath_m = 1.25, kDriveWidth_m = 2.75;

/// Returns the ground of a lot's yard.
///
/// In front of shops and works there are bays for cars, if there is room for a row and its lane.
/// A path goes from the door square to its wall, then to the street. A drive leads to a garage, else past the house at
/// the side with room, else in front of it if a car has room. Neither is laid where it would leave the lot, meet a
/// wall or a mapped barrier, tree or pool; nor a path where a path is mapped in the lot; nor a drive where a drive or
/// a car park is mapped in or beside the lot.
YardGround lay_yard(const map::FeatureView& features, const Lot& lot, const YardRule& rule, const MappedThings& mapped);

}  // namespace citykiln::lots
