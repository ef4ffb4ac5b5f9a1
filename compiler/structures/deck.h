// Meshes of bridge decks: the road, and the slab with parapets below and beside it.
#pragma once

#include "compiler/structures/deck_dimensions.h"
#include "compiler/structures/generate.h"

namespace citykiln::structures {

/// The parts of a deck that a level of detail has.
struct DeckDetail {
  bool has_kerbs = true, has_parapets = true, has_slab = true;
};

/// Adds the strips of the road, from left to right. Returns the cross-section of its top: two corners per strip.
/// @param has_kerbs         If false, raised strips are level with the carriageway and there are no markings.
/// @param lane_tolerance_m  Narrower strips are merged with their neighbours.
Section add_road(const Span& span, std::span<const Rib> ribs, bool has_kerbs, double lane_tolerance_m,
                 GeneratedStructure& generated);

/// Adds the vertical faces between the strips of a road, such as kerbs.
void add_kerb_faces(std::span<const Rib> ribs, const Section& road, Mesh& mesh);

/// Joins the road's cross-section and `below`, which runs from the road's right end to its left end, to a ring without
/// repeated corners.
Section closed_section(const Section& road, const Section& below);

/// Consecutive ribs between which the same edges have no parapet (are open).
struct EdgeRun {
  std::vector<Rib> ribs;
  bool is_left_open = false, is_right_open = false;
};
/// Splits a deck at the ribs where parapet gaps begin or end. Neighbouring runs share that rib.
std::vector<EdgeRun> edge_runs(const Span& bridge, std::span<const Rib> ribs);

/// Returns the ribs, with ribs added where parapet gaps begin or end.
std::vector<Rib> split_at_gaps(const Span& bridge, std::span<const Rib> ribs);

/// Adds the road, and with has_slab the surfaces that close it: parapets, edges, underside and both ends.
void add_deck(const Span& bridge, std::span<const Rib> ribs, const DeckDimensions& dimensions, const DeckDetail& detail,
              double lane_tolerance_m, GeneratedStructure& generated);

}  // namespace citykiln::structures
