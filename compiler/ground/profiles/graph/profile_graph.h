// The graph of all lines with height profiles: stations along roads, rails, bridges and tunnels, joined at common
// nodes. A station is a place along a line at which its height is decided.
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

/// The station spacing for Lines::kPaths, small enough for paths to follow banks and kerbs.
inline constexpr double kPathStation_m = 4;

/// Each way has a station and a knot (a point of its profile) at every multiple of this distance. So the places of
/// stations and knots depend on no data farther away along the way.
inline constexpr double kKnotStretch_m = 1024;

/// The distance beyond a junction's cut after which a road follows its own profile again.
inline constexpr double kJunctionEase_m = 8;

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A directed edge of the graph, between neighbouring stations of a way.
struct Leg {
  std::uint32_t to = 0, way = 0;
  double length_m = 0;
};

/// A station of one way, or a place that several ways share. Heights are stored by node.
struct GraphNode {
  Vec2 at;                    ///< Plane metres.
  bool is_on_ground = false;  ///< True if it belongs to a way on the ground.
  bool is_pinned = false;     ///< True if its height stays on the ground: a bridge or tunnel meets a path there that
                              ///< follows the ground.
  bool is_free_end = false;   ///< Pinned, but may rise or fall: the end of a bridge or tunnel that meets nothing, or
                              ///< that of a tunnel that meets only approach paths.
  std::uint32_t junction = kNone;         ///< The junction on whose plane the node lies.
  std::uint32_t first_leg = 0, legs = 0;  ///< The node's legs in ProfileGraph::legs.
};

/// A node of a way, with its distance along the way.
struct Station {
  double at_m = 0;  ///< Distance along its way from the beginning; not rounded.
  std::uint32_t node = 0;
};

/// A line of the graph: one track of the map.
struct GraphWay {
  const map::Track* track = nullptr;
  std::uint32_t road = kNone;          ///< Index into the given roads; kNone off the ground.
  std::uint32_t off_ground = kNone;    ///< Index among tracks off the ground; kNone on it.
  std::uint32_t first = 0, count = 0;  ///< Range of its stations.
};

/// The lines that a graph contains.
enum class Lines : std::uint8_t {
  kGraded,  ///< Roads and rails, and all bridges and tunnels.
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

/// True if a track is a bridge or in a tunnel.
bool leaves_ground(const map::Track& track);

/// Builds the graph.
///
/// Ways on the ground are joined at common places; ways off the ground are joined with these and with each other at
/// common map nodes. Stations are at such nodes, both ends of ways, multiples of kKnotStretch_m, nodes and cuts of
/// junctions and kJunctionEase_m beyond the cuts, and bends within junctions, and between these at most kStation_m
/// apart. The order of nodes depends on places and ids, not on distant objects or on the order of the input. Roads
/// without a track are left out. In kPaths, places shared with lines that have profiles are pinned stations. O(n log n)
/// in vertices.
ProfileGraph graph_of(const map::FeatureView& features, std::span<const roads::Road> roads,
                      std::span<const roads::Junction> junctions, Lines lines = Lines::kGraded);

/// Returns the height at a distance along a way.
/// @param z_m  Heights by node.
double height_along(const ProfileGraph& graph, const GraphWay& way, std::span<const double> z_m, double at_m);

/// Returns the index among the way's stations of the station before a distance along it, at most the last but one.
std::uint32_t station_before(const ProfileGraph& graph, const GraphWay& way, double at_m);

/// Returns the heights with changed signs, so that lowering becomes raising.
std::vector<double> negated(std::span<const double> z_m);

}  // namespace citykiln::ground
