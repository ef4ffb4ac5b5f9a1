#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <iterator>

#include "compiler/map/locate.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/roads_on_ground.h"
#include "compiler/source/read_osm.h"
#include "tests/compiler/roads/junctions/junction_claims.h"
#include "tests/compiler/roads/real_map.h"
#include "tests/test_files.h"

namespace citykiln::roads {
namespace {

std::vector<std::string> extracts() {
  std::vector<std::string> names = {"berlin/berlin-neukolln.osm",
                                    "monaco/monaco-2023.osm.pbf",
                                    "helsinki/Helsinki.osm.pbf",
                                    "chicago-loop/chicago_loop.osm.pbf",
                                    "liechtenstein/liechtenstein-2015.osm.pbf",
                                    "andorra/andorra-2013.osm.gz",
                                    "andorra/andorra-2023.osm.pbf",
                                    "neubrandenburg/neubrandenburg.osm.bz2",
                                    "porto-roads/porto_portugal.osm.pbf"};
  if (!std::filesystem::exists(real_data("junctions"))) return names;
  for (const auto& entry : std::filesystem::directory_iterator(real_data("junctions")))
    if (entry.path().extension() == ".osm") names.push_back("junctions/" + entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

// Objects in a grid of buckets, by their boxes.
template <typename Thing>
class Squares {
 public:
  explicit Squares(const Box2& all)
      : all_(all),
        columns_(static_cast<int>(all.width() / kSide_m) + 3),
        squares_(static_cast<std::size_t>(columns_) * (static_cast<std::size_t>(all.height() / kSide_m) + 3)) {}

  void add(const Thing& thing, const Box2& box) {
    visit(box, [&](auto& square) { square.push_back(&thing); });
  }

  std::vector<const Thing*> near(const Box2& box) {
    std::vector<const Thing*> found;
    visit(box, [&](const auto& square) { found.insert(found.end(), square.begin(), square.end()); });
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  static constexpr double kSide_m = 64;

  template <typename Visit>
  void visit(const Box2& box, Visit at) {
    const auto number = [](double low, double v) { return std::max(0, static_cast<int>((v - low) / kSide_m) + 1); };
    const int last = static_cast<int>(squares_.size()) / columns_ - 1;
    for (int y = number(all_.min.y, box.min.y); y <= std::min(last, number(all_.min.y, box.max.y)); ++y)
      for (int x = number(all_.min.x, box.min.x); x <= std::min(columns_ - 1, number(all_.min.x, box.max.x)); ++x)
        at(squares_[static_cast<std::size_t>(y) * columns_ + x]);
  }

  Box2 all_;
  int columns_ = 1;
  std::vector<std::vector<const Thing*>> squares_;
};

Shape united(std::vector<GEOSGeometry*> parts) {
  const Shape all(GEOSGeom_createCollection(GEOS_MULTIPOLYGON, parts.data(), static_cast<unsigned>(parts.size())));
  return Shape(GEOSUnaryUnion(all.get()));
}

Shape united(std::span<const Ring> rings) {
  std::vector<GEOSGeometry*> parts;
  for (const Ring& ring : rings) parts.push_back(shape({ring, {}}).release());
  return united(std::move(parts));
}

// The roads of a map, and the outlines made of them.
struct Paved {
  Squares<Road> roads;
  Squares<Polygon> outlines;
};

Paved paved(std::span<const Road> roads, std::span<const std::vector<Polygon>> outlines) {
  Box2 all;
  for (const Road& road : roads)
    for (const Vec2 p : road.axis) all.grow(p);
  Paved paved{Squares<Road>(all), Squares<Polygon>(all)};
  for (const Road& road : roads)
    if (family_of(road.surface) != Family::kOther) paved.roads.add(road, box_of(road.axis).widened(width_m(road)));
  for (const auto& polygons : outlines)
    for (const Polygon& polygon : polygons) paved.outlines.add(polygon, box_of(polygon.outer));
  return paved;
}

// The area of an outline outside all strips: corners, and the area between close roads.
double beyond_strips_m2(const Polygon& outline, Paved& paved) {
  const Box2 box = box_of(outline.outer);
  std::vector<GEOSGeometry*> strips;
  for (const Road* road : paved.roads.near(box))
    for (const Ring& ring : stroke_carriageway(*road, {}))
      if (box_of(ring).touches(box)) strips.push_back(shape({ring, {}}).release());
  return area_of(Shape(GEOSDifference(shape(outline).get(), united(std::move(strips)).get())));
}

// An arm's centre line up to its cut, or to the next node of its junction.
Polyline line_inside(const Junction& junction, std::span<const Road> roads, const Arm& arm, const Cut& cut) {
  if (cut.length_m != kWholeLink_m) return arm_axis(roads, arm, cut.length_m);
  const Polyline& axis = roads[arm.road].axis;
  Polyline line = {axis[arm.vertex]};
  for (std::int64_t v = std::int64_t{arm.vertex} + arm.step; v >= 0 && v < std::ssize(axis); v += arm.step) {
    line.push_back(axis[static_cast<std::size_t>(v)]);
    if (std::ranges::find(junction.nodes, line.back()) != junction.nodes.end()) break;
  }
  return line;
}

// The area of a junction's arms up to their cuts that no outline covers.
double left_to_strips_m2(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                         Paved& paved) {
  std::vector<Ring> rings;
  for (std::size_t a = 0; a < arms.size(); ++a) {
    if (roads[arms[a].road].section.axis_drift != 0) continue;
    Strip strip = carriageway_of(roads[arms[a].road]);
    strip.axis = line_inside(junction, roads, arms[a], junction.cuts[a]);
    strip.axis.erase(std::unique(strip.axis.begin(), strip.axis.end()), strip.axis.end());
    if (arms[a].step < 0) std::ranges::reverse(strip.axis);
    if (strip.axis.size() >= 2) std::ranges::move(stroke(strip), std::back_inserter(rings));
  }
  if (rings.empty()) return 0;
  Box2 box;
  for (const Ring& ring : rings)
    for (const Vec2 p : ring) box.grow(p);
  std::vector<GEOSGeometry*> outlines;
  for (const Polygon* polygon : paved.outlines.near(box)) outlines.push_back(shape(*polygon).release());
  return area_of(Shape(GEOSDifference(united(rings).get(), united(std::move(outlines)).get())));
}

// The difference between a junction and its stroked centre lines.
struct Difference {
  std::size_t junction = 0;
  double beyond_m2 = 0, left_m2 = 0;
  double all_m2() const { return beyond_m2 + left_m2; }
};

// The differences of every stride-th junction.
std::vector<Difference> differences(std::span<const Junction> junctions, std::span<const std::vector<Polygon>> outlines,
                                    std::span<const Road> roads, std::size_t stride) {
  Paved all = paved(roads, outlines);
  const auto arms = arms_of(junctions, roads);
  std::vector<Difference> found;
  for (std::size_t j = 0; j < junctions.size(); j += stride) {
    found.push_back({j, 0, left_to_strips_m2(junctions[j], roads, arms[j], all)});
    for (const Polygon& polygon : outlines[j]) found.back().beyond_m2 += beyond_strips_m2(polygon, all);
  }
  return found;
}

// Prints the ten largest differences of one kind and their positions.
void print_worst(const char* kind, std::vector<Difference> all, std::span<const Junction> junctions,
                 std::span<const Road> roads, const map::Plane& plane) {
  const auto arms = arms_of(junctions, roads);
  std::ranges::sort(all, std::greater{}, &Difference::all_m2);
  for (std::size_t i = 0; i < std::min<std::size_t>(10, all.size()); ++i) {
    const std::size_t j = all[i].junction;
    const LonLat at = plane.backward(box_of(junctions[j].nodes).centre());
    std::printf("  %s at %.6f,%.6f: %.1f m2 beyond strips, %.1f m2 left to them; %zu places, %zu arms, %s\n", kind,
                at.lon_deg, at.lat_deg, all[i].beyond_m2, all[i].left_m2, junctions[j].nodes.size(), arms[j].size(),
                to_string(main_road(roads, arms[j]).id.osm).c_str());
  }
}

// For comparison: osm2streets' outlines cross themselves on 4.3 to 6.0 % of each map, SUMO's on 0.4 to 12.2 %.
class JunctionsReal : public testing::TestWithParam<std::string> {};

TEST_P(JunctionsReal, AreSimpleWithoutSpikesApartAndWithinReach) {
  const std::filesystem::path path = real_data(GetParam());
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "absent: " << path;
  const Geos geos;
  Report report;
  const auto real = read_real_map(path, report);
  ASSERT_TRUE(real) << to_string(real.error());
  const map::Plane plane(real->origin);
  const std::vector<Road> roads = roads_on_ground(real->features, report);

  const std::vector<Junction> junctions = plan_junctions(roads, report);
  const auto outlines = outline_junctions(junctions, roads, 0);
  const Faults faults = faults_of(junctions, outlines, roads);
  EXPECT_GT(junctions.size(), 0u);
  EXPECT_EQ(faults.self_crossing, 0);
  EXPECT_EQ(faults.spikes, 0);
  EXPECT_EQ(faults.beyond_reach, 0);
  EXPECT_LT(faults.overlap_m2, 0.01);

  double beyond = 0, consolidated = 0, left = 0, strips = 0;
  std::vector<Difference> single, several;
  const std::size_t stride = 1 + junctions.size() / 6000;
  const auto all = static_cast<double>(stride);
  for (const Difference& difference : differences(junctions, outlines, roads, stride)) {
    const bool is_single = junctions[difference.junction].nodes.size() == 1;
    (is_single ? single : several).push_back(difference);
    beyond += all * difference.beyond_m2;
    left += all * difference.left_m2;
    if (!is_single) consolidated += all * difference.beyond_m2;
  }
  for (const Road& road : roads)
    if (family_of(road.surface) != Family::kOther) strips += length_m(road.axis) * width_m(road);
  EXPECT_LT(beyond, 0.03 * strips);
  std::printf(
      "%zu junctions; self-crossing %d, spikes %d, beyond reach %d, largest overlap %.6f m2; paved area beyond strips "
      "%.2f %%, %.2f %% in consolidated ones; left to strips %.2f %%; %u merged\n",
      junctions.size(), faults.self_crossing, faults.spikes, faults.beyond_reach, faults.overlap_m2,
      100 * beyond / strips, 100 * consolidated / strips, 100 * left / strips,
      static_cast<unsigned>(report.counts()[Code::kJunctionsMerged]));
  print_worst("one place", single, junctions, roads, plane);
  print_worst("consolidated", several, junctions, roads, plane);
}

INSTANTIATE_TEST_SUITE_P(Extracts, JunctionsReal, testing::ValuesIn(extracts()), [](const auto& info) {
  std::string name = std::filesystem::path(info.param).stem().stem().string();
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

}  // namespace
}  // namespace citykiln::roads
