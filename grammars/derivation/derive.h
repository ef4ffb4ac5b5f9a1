// From a program and a shape to what a building is made of.
//
//   Lot ─ extrude, comp(f) ─┬─ Facade ─ split(y) ─┬─ Floor ─ split(x) ─┬─ Wall          every leaf is a terminal;
//                           ├─ Facade ─ …         └─ Floor ─ …         ├─ Window ─ …    at a tolerance, so is every
//                           └─ Roof                                    └─ Wall          node that moves less
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

/// Counts, not seconds, so that every machine stops at the same shape. Chosen some twenty times above what our largest
/// building asks for.
struct Limits {
  int depth = 96;                    ///< Rules in each other.
  std::uint64_t shapes = 200'000;    ///< Of the whole derivation, terminals and others.
  std::uint64_t steps = 20'000'000;  ///< Operations, values computed and vertices touched.
};

struct DeriveOptions {
  std::string start;                        ///< The rule to begin with; "" for the program's own.
  std::map<std::string, Value> attributes;  ///< Take the place of `attr` values of these names.
  std::uint64_t seed = 0;
  double tolerance_m = 0;   ///< 0: all detail. Else a node that moves the surface by no more ends as its own surface.
  bool keep_start = false;  ///< The start rule's own node is never cut: what it tells apart keeps its looks.
  bool keep_appearances = false;  ///< No cut where something wider than the tolerance looks otherwise.
  bool ids = true;     ///< Terminals and reports have theirs, and their paths; without, they have neither, and that
                       ///< is quicker: what looks the same is copied wherever it came about.
  bool copies = true;  ///< Shapes that are the same but for a motion are derived once.
  /// Where the rules alone bound what a node moves, it ends at once, and looks as it is: the detail it stands for is
  /// not derived, so nothing is counted, reported or looked at there. With keep_appearances, only where nothing that
  /// comes of it may look otherwise; and what a split makes no wider than the tolerance goes to its neighbour, if the
  /// rules alone bound what either moves.
  bool ahead = false;
  Limits limits;
  Occlusion occlusion;  ///< None: nothing stands near.
  RoofBuilder roofs;    ///< None: plain_roof().
};

/// A rule in which a shape came about; 0 is the start.
struct PathNode {
  std::uint32_t parent = 0;
  std::string rule;
};

struct Terminal {
  StableId id{};            ///< Descent: stable_id(parent's, name, which of its kind).
  std::string name;         ///< The shape's name where it ended: "Wall".
  std::uint32_t path = 0;   ///< Into Derivation::paths.
  std::uint32_t look = 0;   ///< Into Derivation::looks.
  std::vector<Face> faces;  ///< Plane metres; empty of an asset. Where the street runs is not told any more.
  std::optional<TextureProjection> texture;
  std::string asset;  ///< i("…"): the instance that fills the scope; "" for none.
  Scope scope;
  bool cut = false;    ///< Ended by the tolerance: stands for all that its rule would have made.
  double error_m = 0;  ///< If cut: between `faces` and what they stand for, Hausdorff, both ways.
  double out_m = 0;    ///< If cut: no point of what they stand for lies farther from `faces`.
};

/// One report(name, value).
struct Reported {
  std::string name;
  Value value;
  StableId shape{};
};

/// Something a rule asked for that cannot be, and what was done instead. Once a place and text.
struct Warning {
  TextPosition place;
  std::string message;
  std::uint64_t times = 0;
};

enum class LimitKind : std::uint8_t { kDepth, kShapes, kSteps };

/// The first place where a limit ended a shape.
struct LimitHit {
  LimitKind kind = LimitKind::kDepth;
  std::string rule;
  TextPosition place;
  std::uint64_t times = 0;  ///< How many shapes it ended.
};

struct Derivation {
  std::vector<Terminal> terminals;  ///< In the rules' order, depth first.
  std::vector<PathNode> paths;
  std::vector<Appearance> looks;
  std::vector<Reported> reports;  ///< Of all detail, at any tolerance.
  std::vector<std::string> printed;
  std::vector<Warning> warnings;  ///< By place.
  std::vector<LimitHit> limits;   ///< At most one a kind.
  std::uint64_t shapes = 0, steps = 0;
  std::uint64_t copied = 0;  ///< Of `shapes`, those that were not derived but copied.
  double error_m = 0;        ///< The largest of the terminals': between this and the derivation at tolerance 0.
};

/// A footprint as the first shape: level at `height_m`; scope x along edge `front` of the outer ring, y up, z outward
/// of that edge. `street` lists the edges that run along the street. Of fewer than three corners: no faces.
Shape lot(const Polygon& footprint, double height_m, std::size_t front, StableId id,
          const std::vector<std::size_t>& street = {});

/// Applies rules until only terminals are left.
///
/// Guarantees: the same bytes for the same arguments on any machine; chance is drawn by (seed, shape's id, purpose,
/// index), so no shape's dice depend on another's. At a tolerance, the union of all terminals' surfaces lies within
/// error_m ≤ tolerance_m of that at tolerance 0, Hausdorff, both ways; instances count as their scopes. Total: what
/// cannot be is a trouble and does nothing; limits end shapes as terminals of their own, and
/// keep the stack under 2 MB. Cost: that of all detail, at any tolerance, but once for each kind of shape where
/// `copies`, and not below what is known `ahead`.
Derivation derive(const Program& program, const Shape& initial, const DeriveOptions& options);

/// "Lot/Facade/Floor".
std::string path_name(const Derivation& derivation, std::uint32_t path);
/// "old_town_house.cga:12:5: message".
std::string warning_line(const Program& program, const Warning& warning);
/// "old_town_house.cga:12:5: the depth limit ended 3 shapes, first of rule Floor".
std::string limit_line(const Program& program, const LimitHit& hit);

}  // namespace citykiln::grammars
