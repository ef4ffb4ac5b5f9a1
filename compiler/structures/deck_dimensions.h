// What a deck is built like: by its class, its width and its span.
//
//     1   parapet, or upstand with a railing          H
//     |=|__________________________________|=|  --- road
//     |_                                    _|   edge
//       `-._____________________________.-'      thickness
#pragma once

#include "compiler/structures/loft.h"

namespace citykiln::structures {

struct DeckDimensions {
  double left_m = 0, right_m = 0;  ///< From the axis to the inner faces of the parapets: the road, pavements and all.
  double thickness_m = 0;          ///< From the road's top to the slab's underside.
  double edge_m = 0;               ///< Of its edges: not thicker than the slab.
  double parapet_m = 0;            ///< How high the parapets stand above the road; solid.
  double railing_m = 0;            ///< How high a railing on them reaches, above the road; 0: there is none.
};

/// How broad a parapet is.
inline constexpr double kParapet_m = 0.25;

/// Concrete slabs are a twentieth of their span thick: from 0.4 to 2 m. Roads for cars have parapets 1 m high, all
/// others railings.
/// @param between_m  The longest way between two supports.
DeckDimensions deck_dimensions(const roads::Road& road, double between_m);

/// The longest way between two of a span's supports: its ends and piers.
double longest_bay_m(const Span& span);

}  // namespace citykiln::structures
