// Checks of outlines by GEOS, a library independent of the one that makes them.
#pragma once

#include <geos_c.h>

#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include "compiler/contract/tolerance.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

using Shape = std::unique_ptr<GEOSGeometry, decltype([](GEOSGeometry* g) { GEOSGeom_destroy(g); })>;

inline void keep_silent(const char*, ...) {}

/// Initialises GEOS for as long as it lives.
struct Geos {
  Geos() { initGEOS(keep_silent, keep_silent); }
  ~Geos() { finishGEOS(); }
};

inline GEOSGeometry* line_ring(const Ring& ring) {
  const auto size = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create(size + 1, 2);
  for (unsigned i = 0; i <= size; ++i) GEOSCoordSeq_setXY(points, i, ring[i % size].x, ring[i % size].y);
  return GEOSGeom_createLinearRing(points);
}

inline Shape shape(const Polygon& polygon) {
  std::vector<GEOSGeometry*> holes;
  for (const Ring& hole : polygon.holes) holes.push_back(line_ring(hole));
  return Shape(GEOSGeom_createPolygon(line_ring(polygon.outer), holes.data(), static_cast<unsigned>(holes.size())));
}

inline double area_of(const Shape& s) {
  double area = 0;
  if (s) GEOSArea(s.get(), &area);
  return area;
}

/// The number of corners whose inside angle is under 10 degrees, with both sides over half a metre.
inline int spikes_of(const Ring& ring) {
  int spikes = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 before = ring[(i + ring.size() - 1) % ring.size()] - ring[i],
               after = ring[(i + 1) % ring.size()] - ring[i];
    if (length(before) <= 0.5 || length(after) <= 0.5) continue;
    const double angle = std::atan2(cross(after, before), dot(after, before));
    if (angle >= 0 && angle < std::numbers::pi / 18) ++spikes;
  }
  return spikes;
}

struct Faults {
  int self_crossing = 0, spikes = 0, beyond_reach = 0;
  double overlap_m2 = 0;
};

/// The distance beyond kJunctionRadius_m that an outline may reach, by the widest road.
inline double beyond_reach_m(std::span<const Road> roads) {
  double widest = 0;
  for (const Road& road : roads)
    if (family_of(road.surface) != Family::kOther) widest = std::max(widest, width_m(road));
  return 0.75 * widest;
}

/// Counts the faults of single outlines.
inline void count_faults(const Junction& junction, std::span<const Polygon> outline, double beyond_m, Faults& faults) {
  const Vec2 centre = box_of(junction.nodes).centre();
  for (const Polygon& polygon : outline) {
    if (GEOSisValid(shape(polygon).get()) != 1) ++faults.self_crossing;
    faults.spikes += spikes_of(polygon.outer);
    for (const Vec2 p : polygon.outer)
      if (distance(p, centre) > kJunctionRadius_m + beyond_m + kQuantum_m) ++faults.beyond_reach;
  }
}

/// The largest area that two outlines share. Polygons are sorted by their western ends, so that only neighbours are
/// compared.
inline double largest_overlap_m2(std::span<const std::vector<Polygon>> outlines) {
  struct Placed {
    Box2 box;
    const Polygon* polygon;
  };
  std::vector<Placed> placed;
  for (const auto& outline : outlines)
    for (const Polygon& polygon : outline) placed.push_back({box_of(polygon.outer), &polygon});
  std::ranges::sort(placed, {}, [](const Placed& p) { return p.box.min.x; });
  double largest = 0;
  for (std::size_t i = 0; i < placed.size(); ++i)
    for (std::size_t j = i + 1; j < placed.size() && placed[j].box.min.x <= placed[i].box.max.x; ++j) {
      if (!placed[i].box.touches(placed[j].box)) continue;
      const Shape shared(GEOSIntersection(shape(*placed[i].polygon).get(), shape(*placed[j].polygon).get()));
      largest = std::max(largest, area_of(shared));
    }
  return largest;
}

inline Faults faults_of(std::span<const Junction> junctions, std::span<const std::vector<Polygon>> outlines,
                        std::span<const Road> roads) {
  Faults faults;
  const double beyond_m = beyond_reach_m(roads);
  for (std::size_t j = 0; j < junctions.size(); ++j) count_faults(junctions[j], outlines[j], beyond_m, faults);
  faults.overlap_m2 = largest_overlap_m2(outlines);
  return faults;
}

}  // namespace citykiln::roads
