// Where roads meet: places that several axes share, and the arms that leave them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/roads/generate.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Roads meet within their family: a footpath that ends on a street is no junction of streets.
enum class Family : std::uint8_t { kStreet, kPath, kOther };
Family family_of(map::LandCoverClass surface);

/// A road as it leaves a place: from axis[vertex] towards axis[vertex + step].
struct Arm {
  std::uint32_t road = 0, vertex = 0;
  std::int32_t step = 1;  ///< 1 or -1.
  auto operator<=>(const Arm&) const = default;
};

/// A place on the plane's grid where axes of one family meet or end.
struct Node {
  Vec2 at;
  Family family{};
  std::vector<Arm> arms;  ///< Sorted.
};

/// All places where at least three arms leave, or two that do not go on into each other (another width, or a bend of
/// more than a right angle), or that are round.
///
/// Axes meet where they share a vertex; those that cross without one do not (bridges). Sorted by place, then family.
/// Total. O(n log n) in vertices.
std::vector<Node> find_nodes(std::span<const Road> roads);

/// How each road's strip ends: with a joint where it goes on into one other road of its family. O(n log n) in vertices.
std::vector<StripEnds> ends_of(std::span<const Road> roads);

/// Two roads, or both ends of a loop, that go on into each other and meet no third: their ends' arms.
struct Joint {
  Arm a, b;
};
/// In the order of places. O(n log n) in vertices.
std::vector<Joint> joints_of(std::span<const Road> roads);

/// From an arm's axis to the kerbs, seen as it leaves.
double left_of(std::span<const Road> roads, const Arm& arm);
double right_of(std::span<const Road> roads, const Arm& arm);

/// The arms of a family that leave each of the places, place by place. O(n log m).
std::vector<Arm> arms_at(std::span<const Road> roads, std::span<const Vec2> places, Family family);

/// The points of an arm from its place on, at most `length_m` long; the last one is interpolated and not snapped.
Polyline walk(std::span<const Road> roads, const Arm& arm, double length_m);

}  // namespace citykiln::roads
