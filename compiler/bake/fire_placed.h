// Trees and lamps: one mesh of a kind, and where it stands.
#pragma once

#include "compiler/bake/firing.h"
#include "compiler/bake/grove.h"
#include "compiler/bake/levels.h"

namespace citykiln::bake {

/// What of the trees and lamps the firing holds.
struct Placed {
  plants::Placed trees;
  Lamps lamps;
};

Placed placed_in(const Firing& firing, const Common& common);

/// One surface instead of trees, where they stand closed and the tolerance is coarse (plants/canopy.h). Not for one
/// eye: there each tree is as fine as it is near.
void fire_canopy(Firing& firing, const Common& common, Placed& placed);

/// What is placed is named before features are numbered, and fired after.
void name_placed(Firing& firing, const Placed& placed);

/// Of the grove's shapes; variants that the tolerance does not tell apart (plants::variants_at) are one.
void fire_trees(Firing& firing, const plants::Placed& placed, const Grove& grove);

/// Those of trees that the firing holds: a pit goes with its tree.
void fire_pits(Firing& firing, const Common& common);

/// Accounts "bake/lamp", "bake/derived lamp". Only what somebody mapped is named where the tolerance drops it.
void fire_lamps(Firing& firing, const Lamps& lamps, const ground::Carving& carving, Report& report);

}  // namespace citykiln::bake
