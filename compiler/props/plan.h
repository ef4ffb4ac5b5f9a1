// Stage 8: barriers and lamps.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/props/recipe.h"

namespace citykiln::props {

struct Props {
  std::vector<Barrier> barriers;  ///< Sorted by id.
  std::vector<Lamp> lamps;        ///< Sorted by id.
};

bool has_hedges(const Props& props);

/// Ledger "props/barrier", "props/point" (points that are not yet modelled are dropped with a code). Total.
Props plan(const map::Features& features, Report& report);

}  // namespace citykiln::props
