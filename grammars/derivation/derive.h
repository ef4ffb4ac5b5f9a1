// Derives a building from a program and its first shape.
//
//   Lot ─ extrude, comp(f) ─┬─ Facade ─ split(y) ─┬─ Floor ─ split(x) ─┬─ Wall          Every leaf is a terminal. At a
//                           ├─ Facade ─ …         └─ Floor ─ …         ├─ Window ─ …    tolerance, so is every node
//                           └─ Roof                                    └─ Wall          that moves the surface less.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grammars/derivation/occlusion.h"
#include "grammars/derivation/roof_builder.h"
#include "grammars/language/syntax.h"
#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// Limits are counts rather than seconds, so that every machine stops at the same shape. They are about twenty times
/// what the largest shipped building needs.
struct Limits {
  int depth = 96;                    ///< Nested rules.
  std::uint64_t shapes = 200'000;    ///< All shapes of the derivation.
  std::uint64_t steps = 20'000'000;  ///< Operations, evaluated values and processed vertices.
};

struct DeriveOptions {
  std::string start;                        ///< The first rule; "" for the start rule of the program.
  std::map<std::string, Value> attributes;  ///< Values of `attr` by name; constants cannot be replaced.
  std::uint64_t seed = 0;
  double tolerance_m = 0;   ///< 0 for all detail; else nodes that move the surface by at most this are simplified.
  bool keep_start = false;  ///< The node of the start rule is never simplified.
  /// A node is simplified only if everything in it that is wider than the tolerance has one appearance.
  bool keep_appearances = false;
  /// Terminals and reports get ids and paths. Without them more nodes are equal, and derivation is faster.
  bool ids = true;
  bool memoise = true;  ///< Shapes that differ by a rigid motion only are derived once (memo.h).
  /// A node is simplified before it is derived if displacement_bound.h bounds what it moves. It keeps its own
  /// appearance, and its detail is not counted and makes no reports or warnings. With keep_appearances this applies
  /// only where no descendant may change the appearance; pieces of a split that are no wider than the tolerance are
  /// then merged into a neighbour (merge_pieces.h).
  bool prune_early = false;
  Limits limits;
  Occlusion occlusion;  ///< Null: nothing stands near.
  RoofBuilder roofs;    ///< Null: form_roofs() at 0.01 m.
};

/// A rule on the way from the start to a terminal. Path 0 is the root.
struct PathNode {
  std::uint32_t parent = 0;
  std::string rule;
};

struct Terminal {
  StableId id{};                 ///< stable_id(id of the parent, name, ordinal among its children).
  std::string name;              ///< The name of the shape: "Wall".
  std::uint32_t path = 0;        ///< Index into Derivation::paths.
  std::uint32_t appearance = 0;  ///< Index into Derivation::appearances.
  std::vector<Face> faces;       ///< Plane metres; empty for an asset. Face::street_edges have no meaning.
  std::optional<TextureProjection> texture;
  std::string asset;  ///< The instance of i("…") that fills the scope; "" for none.
  Scope scope;
  bool simplified = false;  ///< Ended by the tolerance: replaces all that its rule would have made.
  double error_m = 0;       ///< If simplified: an upper bound of the Hausdorff distance between both surfaces.
  double out_m = 0;         ///< If simplified: no point of the detailed surface is farther from `faces`.
};

/// One report(name, value).
struct Reported {
  std::string name;
  Value value;
  StableId shape{};
};

/// A request of a rule that cannot be carried out, and what was done instead. One for each position and text.
struct Warning {
  TextPosition position;
  std::string message;
  std::uint64_t times = 0;
};

enum class LimitKind : std::uint8_t { kDepth, kShapes, kSteps };

/// The first rule at which a limit ended a shape.
struct LimitHit {
  LimitKind kind = LimitKind::kDepth;
  std::string rule;
  TextPosition position;
  std::uint64_t times = 0;  ///< The number of shapes that the limit ended.
};

struct Derivation {
  std::vector<Terminal> terminals;  ///< Depth first, in the order of the rules.
  std::vector<PathNode> paths;
  std::vector<Appearance> appearances;
  std::vector<Reported> reports;  ///< Of all detail, at any tolerance, except in nodes pruned early.
  std::vector<std::string> printed;
  std::vector<Warning> warnings;  ///< Sorted by position.
  std::vector<LimitHit> limits;   ///< At most one of each kind.
  std::uint64_t shapes = 0, steps = 0;
  std::uint64_t copied = 0;  ///< The number of `shapes` that were copied instead of derived.
  double error_m = 0;  ///< The largest error of the terminals: bounds the distance to the derivation at tolerance 0.
};

/// The first shape of a footprint: horizontal at `height_m`; scope x along edge `front` of the outer ring, y up, z
/// outward from that edge. `street` lists the edges along the street. Fewer than three corners give no faces.
Shape lot(const Polygon& footprint, double height_m, std::size_t front, StableId id,
          const std::vector<std::size_t>& street = {});

/// Applies rules until only terminals are left.
///
/// @param options  tolerance_m >= 0.
/// Guarantees: the same result for the same arguments on any machine. A random number depends only on the seed, the id
/// of its shape, its purpose and its index there. At a tolerance, the Hausdorff distance between the union of all
/// terminals and that at tolerance 0 is at most error_m <= tolerance_m; an asset counts as its scope.
/// Bad input: what cannot be done is a warning and has no effect; a limit ends shapes as terminals of their own, and
/// the stack stays under 2 MB.
/// Cost: that of all detail at any tolerance, less what `memoise` and `prune_early` save.
Derivation derive(const Program& program, const Shape& initial, const DeriveOptions& options);

/// "Lot/Facade/Floor".
std::string path_name(const Derivation& derivation, std::uint32_t path);
/// "old_town_house.cga:12:5: message".
std::string warning_line(const Program& program, const Warning& warning);
/// "old_town_house.cga:12:5: the limit of depth ended 3 shapes, the first of rule Floor".
std::string limit_line(const Program& program, const LimitHit& hit);

}  // namespace citykiln::grammars
