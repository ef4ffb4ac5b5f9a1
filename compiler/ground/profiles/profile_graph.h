// All lines with heights of their own as one graph: stations along them, joined where ways meet.
//
//     ground ──●──·──·──●══·══●── ground      ● node of the map that ways share, or a way's end   · put in between
//                       ║
//                       ●══·══●               ═ bridge
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::ground {

/// Stations are at most this far apart: a road's shortest bends of height are seen, and straight pieces keep none of
/// them.
inline constexpr double kStation_m = 16;
/// Of Lines::kPaths: between them they follow banks and kerbs.
inline constexpr double kPathStation_m = 4;

/// Beyond a junction's cut a road is its own again after this.
inline constexpr double kJunctionEase_m = 8;

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Leg {
  std::uint32_t to = 0, way = 0;
  double length_m = 0;
};

struct GraphNode {
  Vec2 at;                         ///< Plane metres.
  bool is_on_ground = false;       ///< Of a way of the ground.
  bool is_pinned = false;          ///< Lies on the ground as it is: where what leaves the ground comes down on a path.
  bool is_free_end = false;        ///< A bridge's end that meets nothing; pinned, but that it may rise.
  std::uint32_t junction = kNone;  ///< On whose plane it lies.
  std::uint32_t first_leg = 0, legs = 0;
};

struct Station {
  double at_m = 0;  ///< Along its way from the beginning; not rounded.
  std::uint32_t node = 0;
};

struct GraphWay {
  const map::Track* track = nullptr;
  std::uint32_t road = kNone;          ///< Of the roads given; kNone off the ground.
  std::uint32_t off_ground = kNone;    ///< Which of the tracks off the ground; kNone on it.
  std::uint32_t first = 0, count = 0;  ///< Its stations.
};

/// Which lines a graph is of.
enum class Lines : std::uint8_t {
  kGraded,  ///< Roads and rails with heights of their own, and all that leaves the ground.
  kPaths,   ///< Paths that leave the ground, and those of the ground that lead up or down to it (approach_paths.h).
  kAll      ///< Both.
};

struct ProfileGraph {
  std::vector<GraphWay> ways;     ///< Sorted by id.
  std::vector<Station> stations;  ///< Way by way, along them.
  std::vector<GraphNode> nodes;   ///< Those of the map by place, then those between, way by way.
  std::vector<Leg> legs;          ///< Node by node.
  double limit_scale = 1;         ///< Of all grade limits.
  Lines lines{};

  std::span<const Station> stations_of(const GraphWay& way) const {
    return std::span(stations).subspan(way.first, way.count);
  }
  std::span<const Leg> legs_of(std::uint32_t node) const {
    return std::span(legs).subspan(nodes[node].first_leg, nodes[node].legs);
  }
};

/// What is told of a node of the map by a lesser way on the ground.
bool leaves_ground(const map::Track& track);

/// The graph of all lines of a kind.
///
/// Ways of the ground meet where they share a place; ways off it meet these and each other where they share a node of
/// the map. Stations: such nodes, both ends, junctions' places, cuts and kJunctionEase_m beyond, bends within
/// junctions, and as many between as kStation_m asks for. Node order hangs on places and ids alone, not on what is far
/// away, nor on the order of the input. Roads without a track are not in the graph. Of kPaths, places that are shared
/// with lines that have heights of their own are stations, and pinned. O(n log n) in vertices.
ProfileGraph graph_of(const map::Features& features, std::span<const roads::Road> roads,
                      std::span<const roads::Junction> junctions, Lines lines = Lines::kGraded);

/// Height at a place along a way, of heights by node.
double height_along(const ProfileGraph& graph, const GraphWay& way, std::span<const double> z_m, double at_m);

/// The station before a place along a way, at most the last but one; relative to the way's first.
std::uint32_t station_before(const ProfileGraph& graph, const GraphWay& way, double at_m);

}  // namespace citykiln::ground
