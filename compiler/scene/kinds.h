// Visits the recipes of a chunk, kind by kind. kinds.inc is the list of kinds.
#pragma once

#include <string_view>

#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// Calls visit(name, recipes) once for each row ELEMENT of kinds.inc, in their order. These are the kinds whose recipes
/// stand for elements of the map. Rows PART, whose recipes only serve others, are skipped.
///
/// An element may have recipes of several kinds, such as a road and a bridge. Callers that describe an element once use
/// its first kind in this order.
/// @param visit  Takes the name of the kind's member of Chunk, such as "buildings", as a std::string_view to static
///               text, and this member: a const std::vector of the kind's type, so that `visit` is generic. It may be
///               empty.
template <typename Visit>
void for_each_element_kind(const Chunk& chunk, Visit visit) {
#define ELEMENT(type, member) visit(std::string_view(#member), chunk.member);
#define PART(type, member)
#include "compiler/scene/kinds.inc"
}

}  // namespace citykiln::scene
