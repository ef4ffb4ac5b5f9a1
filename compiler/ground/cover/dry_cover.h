// Straw and bare ground of dry climates, by land cover class.
#pragma once

#include "compiler/climate/climate_field.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::ground {

/// Shares of dry grass and bare ground, each within 0 … 1.
struct DryShares {
  double straw = 0;  ///< The share of the grass.
  double bare = 0;   ///< The share of the ground.
  bool operator==(const DryShares&) const = default;
};

/// Returns the shares of a class of land cover (dry_covers.inc) in a climate (climate_classes.inc) and month.
DryShares dry_shares(map::LandCoverClass cover, const climate::ClimateMix& climate, climate::LocalMonth month);

/// True if some place of a field has dry shares in a month.
bool is_dry_anywhere(const climate::ClimateField& field, climate::LocalMonth month);

}  // namespace citykiln::ground
