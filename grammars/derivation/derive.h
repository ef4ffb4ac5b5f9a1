// Derives a building: applies the rules of a program to a first shape until only terminals are left. A shape is a
// surface with a local frame (its scope); a node is one application of a rule to a shape; a terminal is a shape without
// a rule.
//
//   Lot ─ extrude, comp(f) ─┬─ Facade ─ split(y) ─┬─ Floor ─ split(x) ─┬─ Wall          Every leaf is a terminal. So
//   is,
//                           ├─ Facade ─ …         └─ Floor ─ …         ├─ Window ─ …    at a tolerance, a node whose
//                           └─ Roof                                    └─ Wall          detail is within the tolerance.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grammars/derivation/context_query.h"
#include "grammars/derivation/roof_builder.h"
#include "grammars/language/syntax.h"
#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// The number of shapes ended by the depth limit at which a derivation is taken to have no end: all further shapes
/// become terminals. Rules that call themselves twice would otherwise reach every other limit first.
inline constexpr std::uint64_t kMostDepthHits = 1000;

/// Limits of a derivation. They are counts rather than seconds, so every machine stops at the same shape. They are
/// about twenty times the needs of the largest shipped building.
struct Limits {
  int depth = 96;                    ///< The depth of nested rules.
  std::uint64_t shapes = 200'000;    ///< The number of shapes in the derivation.
  std::uint64_t steps = 20'000'000;  ///< The number of operations, evaluated values and processed vertices.
};

/// The start, the inputs and the level of detail of a derivation.
struct DeriveOptions {
  std::string start;                        ///< The first rule; "" for the start rule of the program.
  std::map<std::string, Value> attributes;  ///< Values of `attr` by name; constants cannot be replaced.
  std::uint64_t seed = 0;
  double tolerance_m = 0;  ///< 0: all detail; else nodes whose detail moves the surface by at most this are simplified.
  bool keep_start = false;  ///< The node of the start rule is never simplified.
  /// A node is simplified only if all its terminals that are wider than the tolerance have one appearance.
  bool keep_appearances = false;
  /// Terminals and reports get ids and paths. Derivation is faster without ids and paths, since more nodes are equal.
  bool ids = true;
  bool memoise = true;  ///< Shapes that differ only by a rigid motion are derived once (memo.h).
  /// A node is simplified before it is derived if displacement_bound.h shows that its detail is within the tolerance.
  /// Such a node keeps its own appearance; its detail is not counted and makes no reports or warnings. With
  /// keep_appearances, a node is simplified early only if no descendant may change the appearance; pieces of a split
  /// that are no wider than the tolerance are then merged into a neighbour (merge_pieces.h).
  bool prune_early = false;
  /// Parts of walls such as windows and doors become elements: one rectangle each, with all detail beside it, to be
  /// drawn on a picture (element.h). Only with a tolerance.
  bool draw_elements = false;
  Limits limits;
  AnswerContextQuery answer_context_query;  ///< Null: there are no neighbours, entrances or lamps.
  FindFront find_front;                     ///< Null: there are no shop fronts.
  RoofBuilder roofs;                        ///< Null: form_roofs() at 0.01 m.
};

/// A node of the tree of rule names from the start to the terminals. Path 0 is the root.
struct PathNode {
  std::uint32_t parent = 0;
  std::string rule;
};

/// A face of an element: metres from the lower left corner of the element's rectangle, x along its lower edge, y up and
/// z outwards.
struct ElementFace {
  Face face;
  std::uint32_t appearance = 0;  ///< Index into Derivation::appearances.
};

/// All detail of a window, a door or another part of a wall that a level shows as one rectangle.
struct Element {
  double width_m = 0, height_m = 0;  ///< The rectangle's sides rounded to kElementStep_m, from 2 m on to twice and
                                     ///< from 4 m on to four times that.
  std::vector<ElementFace> faces;
};
/// The finest grid of the sizes of elements, so that windows of nearly the same size are the same element.
inline constexpr double kElementStep_m = 0x1p-3;

/// A shape without a rule, or the simplified result of a node: a part of the derived building.
struct Terminal {
  StableId id{};                 ///< stable_id(id of the parent, name, ordinal among the parent's children).
  std::string name;              ///< The name of the shape: "Wall".
  std::uint32_t path = 0;        ///< Index into Derivation::paths.
  std::uint32_t appearance = 0;  ///< Index into Derivation::appearances.
  std::vector<Face> faces;       ///< Plane metres; empty for an asset. Face::street_edges are not set.
  std::optional<TextureProjection> texture;
  std::string asset;  ///< The instance of i("…") that fills the scope; "" for none.
  Scope scope;
  bool simplified = false;  ///< The terminal replaces the detail of its rule, which is within the tolerance.
  /// An upper bound of the Hausdorff distance from the detailed surface, in which round bodies are exact; 0 if the
  /// terminal is neither simplified nor part of a round body.
  double error_m = 0;
  std::uint32_t element = 0;     ///< 1 + index into Derivation::elements for the rectangle of an element; else 0.
  double detail_distance_m = 0;  ///< If simplified: no point of the detailed surface is farther than this from `faces`.
};

/// A value that the rules reported by CGA's report(name, value).
struct Reported {
  std::string name;
  Value value;
  StableId shape{};
};

/// A statement that could not be carried out, with the action taken instead. There is one for each position and text.
struct Warning {
  TextPosition position;
  std::string message;
  std::uint64_t times = 0;
};

/// The member of Limits that ended a shape.
enum class LimitKind : std::uint8_t { kDepth, kShapes, kSteps };

/// A limit that ended shapes, with the first rule that the limit ended.
struct LimitHit {
  LimitKind kind = LimitKind::kDepth;
  std::string rule;
  TextPosition position;
  std::uint64_t times = 0;  ///< The number of shapes that the limit ended.
};

/// The result of derive().
struct Derivation {
  std::vector<Terminal> terminals;  ///< Depth first, in the order of the rules.
  std::vector<PathNode> paths;
  std::vector<Appearance> appearances;
  std::vector<Element> elements;  ///< In the order of their first terminals; equal ones may occur several times.
  std::vector<Reported> reports;  ///< The reports of all detail, at any tolerance, except in nodes pruned early.
  /// The texts that the rules printed by CGA's print(), in order.
  std::vector<std::string> printed;
  std::vector<Warning> warnings;        ///< Sorted by position.
  std::vector<LimitHit> limits;         ///< At most one of each kind.
  std::uint64_t shapes = 0, steps = 0;  ///< The counts that Limits bounds.
  std::uint64_t copied = 0;             ///< The number of shapes that were copied instead of derived.
  /// The largest error of the terminals and of details left out. It bounds the distance to the derivation at tolerance
  /// 0 with exact round bodies.
  double error_m = 0;
};

/// Returns the first shape of a derivation, for a footprint: a horizontal face at `height_m`, with scope x along an
/// edge, y up, and z outward from that edge. A footprint of fewer than three corners gives no faces.
/// @param footprint  Plane metres.
/// @param height_m   The z of the face, in the frame of the plane.
/// @param front      The index of the outer ring's edge along which x runs.
/// @param street     The indices of the outer ring's edges along streets.
Shape lot(const Polygon& footprint, double height_m, std::size_t front, StableId id,
          const std::vector<std::size_t>& street = {});

/// Applies rules until only terminals are left.
///
/// @param options  tolerance_m >= 0.
/// Guarantees: deterministic on any machine. A random number depends only on the seed, the id of its shape, its purpose
/// and its index. The Hausdorff distance between the union of all terminals and the union of the terminals at tolerance
/// 0 is at most error_m <= tolerance_m; an asset counts as its scope. Round bodies are within half the tolerance of
/// exact ones, at tolerance 0 within 1 cm, which error_m includes; only s() after the body was inserted enlarges that.
/// Bad input: a statement that cannot be carried out makes a warning and has no effect. A shape at a limit becomes a
/// terminal. The stack stays under 2 MB.
/// Cost: the cost of deriving all detail, at any tolerance, less the savings of `memoise` and `prune_early`.
Derivation derive(const Program& program, const Shape& initial, const DeriveOptions& options);

/// A fault of rules at one place, in one line: "villa.cga:3:40, rule Building: division by zero".
struct RuleFault {
  std::string text;
  std::uint64_t times = 0;
};
/// Returns the warnings of a derivation and the limits that it hit, at most kMostRuleFaults.
std::vector<RuleFault> rule_faults(const Program& program, const Derivation& derivation);
inline constexpr std::size_t kMostRuleFaults = 16;

/// Returns the rule names from the start to a node: "Lot/Facade/Floor".
/// @param path  An index into Derivation::paths.
std::string path_name(const Derivation& derivation, std::uint32_t path);
/// Returns a warning as a line: "old_town_house.cga:12:5: message".
std::string warning_line(const Program& program, const Warning& warning);
/// Returns a hit limit as a line: "old_town_house.cga:12:5: the limit of depth ended 3 shapes, the first of rule
/// Floor".
std::string limit_line(const Program& program, const LimitHit& hit);

}  // namespace citykiln::grammars
