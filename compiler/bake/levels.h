// The levels of a tile before they are fired: what they have in common is made once, and their ground together.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compiler/bake/fire_ground.h"
#include "compiler/bake/view_levels.h"
#include "compiler/buildings/expand.h"
#include "compiler/plants/expand.h"
#include "compiler/plants/prototypes/canopy.h"
#include "compiler/props/expand.h"
#include "compiler/props/tree_pits.h"
#include "compiler/scene/ground_carving.h"
#include "compiler/scene/ground_cover.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {

/// What stands along streets. Mapped ones first.
struct Lamps {
  std::vector<props::StreetLamp> standing;
  std::size_t mapped = 0;
};

/// What the levels on one side of kPlainRoads_m have in common: how the ground is carved, and what stands on it.
struct Common {
  ground::Carving carving;
  plants::Placed trees;
  plants::Placed blades;  ///< For levels up to plants::kBlades_m; empty where there are none.
  Report of_trees;
  std::vector<props::TreePit> pits;
  Lamps lamps;
  std::vector<structures::Stairs> stairs;
  std::map<double, plants::Canopy> canopies;  ///< Of whole tiles, by tolerances from plants::kCanopyFrom_m on.
};

/// Whether hedges along lines are rows of plants at a tolerance, no bands. For one eye they are at all: a hedge may be
/// near and far.
inline bool has_hedge_plants(double tolerance_m) { return tolerance_m < scene::kPlainRoads_m; }

/// One an object of the chunk.
using Houses = std::vector<buildings::Expanded>;

/// One level's part of the ground, and its houses where levels share what those are made of.
struct Level {
  double tolerance_m;
  std::shared_ptr<const Common> common;
  scene::GroundCover cover;
  std::vector<SeenCell> seen;
  std::vector<ground::GroundMesh> cells{};
  Report of_cells{};
  std::optional<Houses> houses{};
  Report of_houses{};
};

/// Whole tiles, with all but houses.
std::vector<Level> levels_of(const scene::Header& header, const scene::Chunk& chunk, std::span<const double> ladder_m,
                             int threads);

/// For one eye: a level a part, with the cells that have its tolerance.
std::vector<Level> levels_seen(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                               std::span<const double> tolerances_m, int threads);

}  // namespace citykiln::bake
