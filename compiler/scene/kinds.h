// Visits the recipes of a chunk, kind by kind. kinds.inc is the list of kinds.
#pragma once

#include <string_view>

#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// Calls visit(name, objects) for each kind whose recipes stand for elements, with the name of its member of Chunk.
/// An element of several recipes is described by the first.
template <typename Visit>
void for_each_element_kind(const Chunk& chunk, Visit visit) {
#define ELEMENT(type, member) visit(std::string_view(#member), chunk.member);
#define PART(type, member)
#include "compiler/scene/kinds.inc"
}

}  // namespace citykiln::scene
