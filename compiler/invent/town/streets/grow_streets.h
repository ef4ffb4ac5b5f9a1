// Streets: lines that grow along the field from streets that are there, until they meet another.
//
//     ═╤═══════╤══ main road     1. seeds stand along a street, as far apart as streets should be
//      │       │                 2. a street grows from a seed along the field, step by step
//      ├───┬───┤                 3. it joins a street that lies ahead, and goes on across some of them
//      │   │   ╵                 4. it ends beside a street of its direction; a short end is taken back
#pragma once

#include "compiler/invent/town/streets/street_field.h"

namespace citykiln::invent {

/// Adds the streets of a town to its main roads.
///
/// Guarantees: the graph stays connected if it was, as all that grows begins on it; segments meet at vertices only.
/// Source: Parish, Müller, "Procedural Modeling of Cities", SIGGRAPH 2001, section 3.2 (growth, and snapping by local
/// constraints). Cost: O(streets).
void grow_streets(const TownPlan& plan, const StreetField& field, StreetGraph& graph);

}  // namespace citykiln::invent
