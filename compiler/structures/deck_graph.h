// Bridges as a graph: stations along their axes, joined where ways share a node.
//
//     ground──●──·──·──●──·──●──ground        ● node of the map   · station put in between
//                      │
//                      ●──·──ground
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::structures {

/// Stations are at most this far apart: fine enough that a rise of 6 % over a bridge is seen as one.
inline constexpr double kStation_m = 8;

/// Height that a deck keeps above what it crosses, for each layer: a road's clear height (4.5 to 5 m) and the slab.
inline constexpr double kClearance_m = 5.5;

struct Leg {
  std::uint32_t to = 0;
  double length_m = 0;
};

struct Station {
  Vec2 at;                   ///< Plane metres, snapped.
  double ground_m = 0;       ///< Of the terrain below.
  double clearance_m = 0;    ///< Wanted above the ground: the largest of its bridges'.
  bool is_anchored = false;  ///< The deck lies on the ground here.
  std::vector<Leg> legs;
};

struct DeckGraph {
  std::vector<Station> stations;  ///< Nodes of the map by id, then those put in between by bridge.
  std::vector<std::vector<std::uint32_t>>
      bridges;  ///< Stations of each bridge in order; parallel to the bridges given.
};

/// Anchored are the nodes that a bridge shares with a way of the ground or a tunnel, and ends that meet nothing
/// (kBridgeWithoutGround). O(n log n) in nodes.
DeckGraph graph_of(const std::vector<const map::Track*>& bridges, const map::Features& features,
                   const map::Heightfield& heights, Report& report);

}  // namespace citykiln::structures
