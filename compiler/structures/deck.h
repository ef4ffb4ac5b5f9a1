// The deck of a bridge: its road, and the slab with parapets that closes it from below.
#pragma once

#include "compiler/structures/deck_dimensions.h"
#include "compiler/structures/generate.h"

namespace citykiln::structures {

/// What of the slab a tolerance keeps.
struct DeckDetail {
  bool has_kerbs = true, has_parapets = true, has_slab = true;
};

/// Adds the road's strips, from left to right, and returns its section: two corners a strip.
/// @param has_kerbs         False: what is raised lies level with the carriageway, and nothing is marked.
/// @param lane_tolerance_m  Strips that are narrower are part of their neighbours.
Section add_road(const Span& span, std::span<const Rib> ribs, bool has_kerbs, double lane_tolerance_m,
                 GeneratedStructure& generated);

/// What stands upright between a road's strips.
void add_kerb_faces(std::span<const Rib> ribs, const Section& road, Mesh& mesh);

/// A road's section and what goes round from its right end to its left one, as one ring without repeats.
Section closed_section(const Section& road, const Section& round);

/// A run of ribs along which the same edges have parapets.
struct EdgeRun {
  std::vector<Rib> ribs;
  bool is_left_open = false, is_right_open = false;
};
/// All of a deck, cut where an opening begins or ends. Neighbours share their rib.
std::vector<EdgeRun> edge_runs(const Span& bridge, std::span<const Rib> ribs);

/// The ribs, and those where an opening begins or ends.
std::vector<Rib> split_at_gaps(const Span& bridge, std::span<const Rib> ribs);

/// Adds the road's strips, and, where there is a slab, what closes them: parapets, edges, underside, both ends.
/// @param lane_tolerance_m  Strips that are narrower are part of their neighbours.
void add_deck(const Span& bridge, std::span<const Rib> ribs, const DeckDimensions& shape, const DeckDetail& detail,
              double lane_tolerance_m, GeneratedStructure& generated);

}  // namespace citykiln::structures
