// Bakes tufts of grass and flowers beside paths (plants/tufts), on levels with Detail::kGrassTufts. They are drawn from
// seed and land cover alone, so no recipe has them. They do not count in the error.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "compiler/bake/baking.h"
#include "compiler/bake/tile_levels.h"
#include "compiler/plants/tufts/tuft_form.h"

namespace citykiln::bake {

/// Side of the squares that have at most one tuft each, metres. Views are seen from near the ground and have small
/// squares; a whole tile has about a fortieth of the tufts per area.
inline constexpr double kViewTuftSpacing_m = 0.15625, kTileTuftSpacing_m = 1;

/// Tufts that share a mesh. The colour is about that of the ground, in 256ths of linear reflectance.
struct TuftKind {
  plants::TuftForm form{};
  std::uint8_t variant = 0;
  std::array<std::uint8_t, 3> colour{};
  auto operator<=>(const TuftKind&) const = default;
};

/// The tufts of a tile, part or cell.
using BakedTufts = std::map<TuftKind, std::vector<Placement>>;

/// Returns the tufts on the ground of a level, where its tolerance has Detail::kGrassTufts: in a view that is near the
/// eye. None on snow, rock and steep ground. Linear in the tufts.
BakedTufts tufts_on(const Baking& baking, const TileLevel& level);

/// Adds tufts as instances. Their features are in BakedTile::features.
void bake_tufts(Baking& baking, const BakedTufts& tufts);

}  // namespace citykiln::bake
