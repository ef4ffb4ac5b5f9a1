// The deck of a bridge: its road, and the slab with parapets that closes it from below.
#pragma once

#include "compiler/structures/deck_shape.h"
#include "compiler/structures/expand.h"

namespace citykiln::structures {

/// What of the slab a tolerance keeps.
struct DeckDetail {
  bool has_kerbs = true, has_parapets = true, has_slab = true;
};

/// Adds the road's strips, from left to right, and returns its section: two corners a strip.
/// @param has_kerbs         False: what is raised lies level with the carriageway, and nothing is marked.
/// @param lane_tolerance_m  Strips that are narrower are part of their neighbours.
Section add_road(const Span& span, std::span<const Rib> ribs, bool has_kerbs, double lane_tolerance_m,
                 Expanded& expanded);

/// What stands upright between a road's strips.
void add_steps(std::span<const Rib> ribs, const Section& road, Mesh& mesh);

/// A road's section and what goes round from its right end to its left one, as one ring without repeats.
Section outline_of(const Section& road, const Section& round);

/// Adds the road's strips, and, where there is a slab, what closes them: parapets, edges, underside, both ends.
/// @param lane_tolerance_m  Strips that are narrower are part of their neighbours.
void add_deck(const Span& bridge, std::span<const Rib> ribs, const DeckShape& shape, const DeckDetail& detail,
              double lane_tolerance_m, Expanded& expanded);

}  // namespace citykiln::structures
