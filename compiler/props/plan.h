// Plans props: barriers and mapped lamps.
#pragma once

#include <span>
#include <tuple>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/props/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::props {

/// The props of a map.
struct Props {
  std::vector<Barrier> barriers;  ///< Sorted by id.
  std::vector<Lamp> lamps;        ///< Sorted by id.
};

/// True if a barrier is a hedge.
bool has_hedges(const Props& props);

/// The order of barriers: by id, then by axis.
inline auto order_of(const Barrier& barrier) { return std::tie(barrier.id, barrier.axis); }

/// Returns the props of a map. A barrier that leaves the extent is cut 4 m outside of it; its parts are numbered along
/// it. Mapped kerbs that are those of a street (mapped_kerbs.h) are merged with it. Ledger "props/barrier",
/// "props/point". Props outside of the extent are dropped as kOutsideBounds. Cannot fail.
/// @param roads  The streets on the ground.
Props plan(const map::FeatureView& features, std::span<const roads::Road> roads, Report& report);

}  // namespace citykiln::props
