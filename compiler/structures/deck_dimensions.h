// Dimensions of a bridge deck: functions of the road's class and width, and of the longest bay. A bay is the part of a
// span (a bridge) between neighbouring supports.
//
//     1   parapet, or upstand with a railing          H
//     |=|__________________________________|=|  --- road
//     |_                                    _|   edge
//       `-._____________________________.-'      thickness
#pragma once

#include "compiler/structures/loft.h"

namespace citykiln::structures {

/// Dimensions of one deck. All are in metres and at least 0.
struct DeckDimensions {
  double left_m = 0, right_m = 0;  ///< From the axis to the inner faces of the parapets, pavements included.
  double thickness_m = 0;          ///< From the top of the road to the underside of the slab.
  double edge_m = 0;               ///< Thickness of the slab at its left and right edges, at most thickness_m.
  double parapet_m = 0;            ///< Height of the solid parapets above the road.
  double railing_m = 0;            ///< Height of the railing's top above the road; 0 if there is none.
};

/// Width of a parapet.
inline constexpr double kParapet_m = 0.25;

/// Returns the dimensions of a deck. The slab's thickness is a 20th of the bay, at least 0.4 and at most 2 m. Roads for
/// cars have parapets of 1 m; paths and railways have railings.
/// @param bay_m  The largest distance between two supports.
DeckDimensions deck_dimensions(const roads::Road& road, double bay_m);

/// Returns the largest distance between neighbouring supports of a span, in metres. Its ends and its piers are
/// supports.
double longest_bay_m(const Span& span);

}  // namespace citykiln::structures
