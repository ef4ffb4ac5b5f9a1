// Adds the mesh of a bridge deck: the strips of the road on top, and the concrete slab with its parapets.
//
//   section (cross-section):   parapet |=|_____road_____|=| parapet     seen along the axis
//                                      |___            ___|
//                                          `--slab----'
//
// A span (recipe.h) is a bridge or a tunnel: a road with its axis, lanes and profile of heights. add_road() and
// add_kerb_faces() are for both, the other functions for bridges. A rib is a straight line across the span at one
// distance along the axis; surfaces are linear between neighbouring ribs (ribs.h). A section is a list of corners in
// the plane of a rib: metres to the left of the axis, and metres above the road (loft.h). A parapet gap is a part of an
// edge without parapet, as another deck continues there. Meshes are in plane metres, z up.
#pragma once

#include "compiler/structures/deck_dimensions.h"
#include "compiler/structures/generate.h"

namespace citykiln::structures {

/// Parts of a deck that a level of detail includes.
struct DeckDetail {
  bool has_kerbs = true;     ///< True if pavements stand a kerb above the carriageway, and strips may have markings.
  bool has_parapets = true;  ///< True if parapets rise above the slab's edges. Without a slab there are none.
  bool has_slab = true;      ///< False: the deck is the road's surface alone.
};

/// Adds the lanes of the road as strips along the ribs, from left to right. Returns the section of the road's top: two
/// corners per strip, its left one and its right one.
///
/// @param span              Bridge or tunnel that gives lanes and surfaces.
/// @param ribs              Ribs of the span, in order along it; at least two.
/// @param has_kerbs         If false, pavements and other raised strips are level with the carriageway, and no strip
///                          has markings.
/// @param lane_tolerance_m  Strips that are narrower than this are merged into their inner neighbour.
/// @param generated         Receives the meshes of the strips.
Section add_road(const Span& span, std::span<const Rib> ribs, bool has_kerbs, double lane_tolerance_m,
                 GeneratedStructure& generated);

/// Adds the vertical faces between neighbouring strips of different height, such as kerbs.
/// @param road  Result of add_road().
void add_kerb_faces(std::span<const Rib> ribs, const Section& road, Mesh& mesh);

/// Returns the closed section of the deck: the road's top, then `below`, without repeated corners.
/// @param road   Section of the road's top, from left to right (result of add_road()).
/// @param below  Section of parapets and slab, from the road's right end to its left end.
Section closed_section(const Section& road, const Section& below);

/// A stretch of a deck along which neither edge changes between having a parapet and being open.
struct EdgeRun {
  std::vector<Rib> ribs;                             ///< Ribs of the stretch, at least two.
  bool is_left_open = false, is_right_open = false;  ///< True if the edge has no parapet.
};
/// Divides a deck into stretches with constant edges, in order. Neighbouring stretches share the rib between them.
/// @param ribs  Result of with_gap_ribs(): edges change at ribs only.
std::vector<EdgeRun> edge_runs(const Span& bridge, std::span<const Rib> ribs);

/// Returns the ribs and, added in order, one rib at each begin and each end of a parapet gap. Call it before
/// edge_runs() and add_deck().
std::vector<Rib> with_gap_ribs(const Span& bridge, std::span<const Rib> ribs);

/// Adds the road and, if detail.has_slab, the slab: kerb faces, edges, parapets, underside and both ends, which close
/// it to a solid. If not detail.has_parapets, the slab's edges end at the height of the road.
///
/// @param ribs              Result of with_gap_ribs().
/// @param dimensions        Result of deck_dimensions().
/// @param lane_tolerance_m  Parameter of add_road().
/// @param generated         Receives the meshes.
void add_deck(const Span& bridge, std::span<const Rib> ribs, const DeckDimensions& dimensions, const DeckDetail& detail,
              double lane_tolerance_m, GeneratedStructure& generated);

}  // namespace citykiln::structures
