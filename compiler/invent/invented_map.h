// An invented map: points, lines and areas with the tags that mappers write, on a plane in metres.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::invent {

/// Keys and values as OpenStreetMap has them, sorted by key.
using Tags = std::vector<std::pair<std::string, std::string>>;

struct InventedPoint {
  Vec2 position;
  Tags tags;
};

/// A way that is not closed into an area.
struct InventedLine {
  Polyline axis;
  Tags tags;
};

/// A closed way, or a multipolygon if it has holes.
struct InventedArea {
  Polygon polygon;
  Tags tags;
};

/// All that is written to map.osm.pbf. The frame is local: x east, y north, in metres from the middle of the world.
/// write_map() rounds positions to 1e-7 degrees, about 1 cm, and makes equal ones one node: lines meet where they share
/// a point of their axes. Tags of points on a line, such as crossings, are those of its node.
struct InventedMap {
  std::vector<InventedPoint> points;
  std::vector<InventedLine> lines;
  std::vector<InventedArea> areas;
};

}  // namespace citykiln::invent
