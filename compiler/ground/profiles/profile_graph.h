// The graph of all lines with profiles: stations along them, connected where ways meet.
//
//     ground ──●──·──·──●══·══●── ground      ● map node shared by ways, or a way's end   · station between them
//                       ║
//                       ●══·══●               ═ bridge
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::ground {

/// Station spacing for Lines::kPaths, which follow banks and kerbs between stations.
inline constexpr double kPathStation_m = 4;

/// Each way has a station and a knot at every multiple of this: where its stations and knots are depends on nothing
/// farther away along it.
inline constexpr double kKnotStretch_m = 1024;

/// Beyond a junction's cut its road follows its own profile again after this distance.
inline constexpr double kJunctionEase_m = 8;

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Leg {
  std::uint32_t to = 0, way = 0;
  double length_m = 0;
};

struct GraphNode {
  Vec2 at;                    ///< Plane metres.
  bool is_on_ground = false;  ///< Of a way on the ground.
  bool is_pinned = false;     ///< Stays on the ground: where a bridge or tunnel meets a path that follows the ground.
  bool is_free_end = false;   ///< Pinned, but may rise or fall: a bridge's end that meets nothing, or a tunnel's that
                              ///< meets approach paths alone.
  std::uint32_t junction = kNone;  ///< The junction plane that it lies on.
  std::uint32_t first_leg = 0, legs = 0;
};

struct Station {
  double at_m = 0;  ///< Along its way from the beginning; not rounded.
  std::uint32_t node = 0;
};

struct GraphWay {
  const map::Track* track = nullptr;
  std::uint32_t road = kNone;          ///< Index into the roads given; kNone off the ground.
  std::uint32_t off_ground = kNone;    ///< Index among tracks off the ground; kNone on it.
  std::uint32_t first = 0, count = 0;  ///< Its stations.
};

/// Which lines a graph contains.
enum class Lines : std::uint8_t {
  kGraded,  ///< Roads and rails, and everything that leaves the ground.
  kPaths,   ///< Paths that leave the ground, and their approaches (approach_paths.h).
  kAll      ///< Both.
};

struct ProfileGraph {
  std::vector<GraphWay> ways;     ///< Sorted by id.
  std::vector<Station> stations;  ///< Way by way, along them.
  std::vector<GraphNode> nodes;   ///< Map nodes by place, then stations between, way by way.
  std::vector<Leg> legs;          ///< Node by node.
  double limit_scale = 1;         ///< Factor on all grade limits.
  Lines lines{};

  std::span<const Station> stations_of(const GraphWay& way) const {
    return std::span(stations).subspan(way.first, way.count);
  }
  std::span<const Leg> legs_of(std::uint32_t node) const {
    return std::span(legs).subspan(nodes[node].first_leg, nodes[node].legs);
  }
};

/// Returns whether a track is a bridge or in a tunnel.
bool leaves_ground(const map::Track& track);

/// Builds the graph.
///
/// Ways on the ground meet where they share a place; ways off it meet these and each other where they share a map node.
/// Stations: such nodes, both ends, multiples of kKnotStretch_m, the places and cuts of junctions and kJunctionEase_m
/// beyond them, bends within junctions, and others between so that none are farther apart than kStation_m. The order of
/// nodes depends on places and ids, not on distant objects or on the order of the input. Roads without a track are left
/// out. In kPaths, places shared with lines that have profiles are pinned stations. O(n log n) in vertices.
ProfileGraph graph_of(const map::Features& features, std::span<const roads::Road> roads,
                      std::span<const roads::Junction> junctions, Lines lines = Lines::kGraded);

/// Returns the height at a distance along a way, for heights by node.
double height_along(const ProfileGraph& graph, const GraphWay& way, std::span<const double> z_m, double at_m);

/// Returns the station before a distance along a way, at most the last but one; counted from the way's first.
std::uint32_t station_before(const ProfileGraph& graph, const GraphWay& way, double at_m);

/// Returns the heights with their signs changed, so that lowering becomes raising.
std::vector<double> negated(std::span<const double> z_m);

}  // namespace citykiln::ground
