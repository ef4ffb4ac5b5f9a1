// Bridge decks: the road and the slab with parapets that closes it from below.
#pragma once

#include "compiler/structures/deck_dimensions.h"
#include "compiler/structures/generate.h"

namespace citykiln::structures {

/// The parts of a deck that a level has.
struct DeckDetail {
  bool has_kerbs = true, has_parapets = true, has_slab = true;
};

/// Adds the strips of the road, from left to right, and returns its section: two corners per strip.
/// @param has_kerbs         If false, raised strips are level with the carriageway and there are no markings.
/// @param lane_tolerance_m  Narrower strips are merged with their neighbours.
Section add_road(const Span& span, std::span<const Rib> ribs, bool has_kerbs, double lane_tolerance_m,
                 GeneratedStructure& generated);

/// Adds the vertical faces between the strips of a road.
void add_kerb_faces(std::span<const Rib> ribs, const Section& road, Mesh& mesh);

/// Returns a ring of the road's section and `below`, which goes from its right end to its left one, without repeats.
Section closed_section(const Section& road, const Section& below);

/// Consecutive ribs along which the same edges have parapets.
struct EdgeRun {
  std::vector<Rib> ribs;
  bool is_left_open = false, is_right_open = false;
};
/// Splits a deck where parapet gaps begin or end. Neighbouring runs share their rib.
std::vector<EdgeRun> edge_runs(const Span& bridge, std::span<const Rib> ribs);

/// Returns the ribs and those at which parapet gaps begin or end.
std::vector<Rib> split_at_gaps(const Span& bridge, std::span<const Rib> ribs);

/// Adds the road, and with has_slab the surfaces that close it: parapets, edges, underside and both ends.
void add_deck(const Span& bridge, std::span<const Rib> ribs, const DeckDimensions& dimensions, const DeckDetail& detail,
              double lane_tolerance_m, GeneratedStructure& generated);

}  // namespace citykiln::structures
