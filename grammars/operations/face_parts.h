// Distributes faces among selectors, for comp, setback and the operations that cut footprints (shapeL …).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "grammars/derivation/execution.h"

namespace citykiln::grammars {

/// The key of a selector `key : body`: a word or an index.
struct Key {
  std::string_view word;  ///< Points into the program, which outlives the run.
  std::optional<std::size_t> index;
};

/// Returns the keys of a statement's selectors, in their order. A word that is not among `words` raises a warning and
/// selects nothing.
///
/// @param words  The allowed words, each between blanks: " front back ".
std::vector<Key> keys_of(Execution& execution, const Statement& statement, const char* words);

/// Returns the index of the key with this word; -1 if there is none.
int index_of(const std::vector<Key>& keys, std::string_view word);

/// A face and the index of the selector that selects it; -1 for none.
struct PartOf {
  Face face;
  int selector = -1;
};

/// Returns by how much cutting moves the surface. Cut edges lie on the plane of each face, so planar faces do not move;
/// others move by up to bend_m(), their extent along their normal.
Displacement of_cutting(std::span<const Face> faces);

/// Applies the bodies of the selectors to the faces: for `:` to each face, for `=` to all together. A single face gets
/// its own axes as scope, several keep the current axes. Faces without a selector are dropped.
/// @param parts  Their union is the current surface, moved by at most `moved`.
void spawn_parts(Execution& execution, const Statement& statement, std::vector<PartOf> parts, Displacement moved);

/// The directions right and front of a face, as axes of the scope, which are unit vectors. They lie exactly in the
/// plane of a face that is square to an axis. `front` is the scope's z for horizontal faces such as lots, and downwards
/// for walls.
struct PlanAxes {
  Vec3 right, front;
};
PlanAxes plan_axes(const Scope& scope, const Face& face);

}  // namespace citykiln::grammars
