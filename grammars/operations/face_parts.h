// What comp, setback and the shape operations share: faces given to selectors.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "grammars/derivation/run.h"

namespace citykiln::grammars {

/// A selector's key: a word or an index.
struct Key {
  std::string_view word;  ///< Lives in the program.
  std::optional<std::size_t> index;
};

/// The keys of a statement's selectors; a word that is not in `words` is a trouble and selects nothing.
std::vector<Key> keys_of(Execution& execution, const Statement& statement, const char* words);

/// A face, and the selector that has it; -1 for none.
struct PartOf {
  Face face;
  int selector = -1;
};

/// What cutting faces up in their planes moves: nothing, where they are flat.
Displacement of_cutting(std::span<const Face> faces);

/// Hands the faces over: to `:` one shape each, to `=` all in one. Single faces get the scope of a face; several keep
/// the current scope's axes. Faces that no selector has vanish. Together the parts have to cover the current surface,
/// but for `moved`.
void spawn_parts(Execution& execution, const Statement& statement, std::vector<PartOf> parts, Displacement moved);

/// A face's own directions in its plane, by the scope: for lots and roofs `front` is the scope's z, for walls the foot.
struct PlanAxes {
  Vec3 right, front;
};
PlanAxes plan_axes(const Scope& scope, const Face& face);

}  // namespace citykiln::grammars
