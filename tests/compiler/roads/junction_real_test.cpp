#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "compiler/map/locate.h"
#include "compiler/roads/expand.h"
#include "compiler/roads/plan.h"
#include "compiler/source/read_osm.h"
#include "tests/compiler/roads/junction_claims.h"

namespace citykiln::roads {
namespace {

const std::filesystem::path kData = CITYKILN_DATA;

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
  if (!std::filesystem::exists(kData / "junctions")) return names;
  for (const auto& entry : std::filesystem::directory_iterator(kData / "junctions"))
    if (entry.path().extension() == ".osm") names.push_back("junctions/" + entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

// Roads by the squares of the plane that they come near.
class Squares {
 public:
  explicit Squares(std::span<const Road> roads) {
    for (const Road& road : roads)
      for (const Vec2 p : road.axis) all_.grow(p);
    columns_ = static_cast<int>(all_.width() / kSide_m) + 3;
    squares_.resize(static_cast<std::size_t>(columns_) * (static_cast<std::size_t>(all_.height() / kSide_m) + 3));
    for (const Road& road : roads)
      if (family_of(road.surface) != Family::kOther)
        visit(box_of(road.axis).widened(width_m(road)), [&](auto& square) { square.push_back(&road); });
  }

  std::vector<const Road*> near(const Box2& box) {
    std::vector<const Road*> found;
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
  std::vector<std::vector<const Road*>> squares_;
};

// What an outline covers that no road's strip does: corners, and what is between close roads.
double beyond_strips_m2(const Polygon& outline, Squares& squares) {
  const Box2 box = box_of(outline.outer);
  std::vector<GEOSGeometry*> strips;
  for (const Road* road : squares.near(box))
    for (const Ring& ring : stroke(carriageway_of(*road)))
      if (box_of(ring).touches(box)) strips.push_back(shape({ring, {}}).release());
  const Shape all(GEOSGeom_createCollection(GEOS_MULTIPOLYGON, strips.data(), static_cast<unsigned>(strips.size())));
  const Shape covered(GEOSUnaryUnion(all.get()));
  return area_of(Shape(GEOSDifference(shape(outline).get(), covered.get())));
}

// For scale, osm2streets crosses itself on 4.3 to 6.0 % of each of these, SUMO on 0.4 to 12.2 %.
class JunctionsReal : public testing::TestWithParam<std::string> {};

TEST_P(JunctionsReal, AreSimpleWithoutSpikesApartAndWithinReach) {
  const std::filesystem::path path = kData / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "absent: " << path;
  const Geos geos;
  Report report;
  const auto osm = source::read_osm(path, 0, report);
  ASSERT_TRUE(osm) << to_string(osm.error());
  const source::LonLatBox box = map::choose_box(*osm, {});
  const std::vector<Road> roads =
      plan(map::locate(*osm, map::Plane(map::default_origin(box)), box, {}, report), report);

  const std::vector<Junction> junctions = plan_junctions(roads, report);
  const auto outlines = outline(junctions, roads, 0);
  const Faults faults = faults_of(junctions, outlines, roads);
  EXPECT_GT(junctions.size(), 0u);
  EXPECT_EQ(faults.self_crossing, 0);
  EXPECT_EQ(faults.spikes, 0);
  EXPECT_EQ(faults.beyond_reach, 0);
  EXPECT_LT(faults.overlap_m2, 0.01);

  Squares squares(roads);
  double beyond = 0, consolidated = 0, strips = 0;
  for (std::size_t j = 0; j < junctions.size(); ++j)
    for (const Polygon& polygon : outlines[j]) {
      const double area = beyond_strips_m2(polygon, squares);
      beyond += area;
      if (junctions[j].places.size() > 1) consolidated += area;
    }
  for (const Road& road : roads)
    if (family_of(road.surface) != Family::kOther) strips += length_m(road.axis) * width_m(road);
  EXPECT_LT(beyond, 0.03 * strips);
  std::printf(
      "%zu junctions; self-crossing %d, spikes %d, beyond reach %d, largest overlap %.6f m2; paved area beyond strips "
      "%.2f %%, %.2f %% in consolidated ones; %u merged\n",
      junctions.size(), faults.self_crossing, faults.spikes, faults.beyond_reach, faults.overlap_m2,
      100 * beyond / strips, 100 * consolidated / strips,
      static_cast<unsigned>(report.counts()[Code::kJunctionsMerged]));
}

INSTANTIATE_TEST_SUITE_P(Extracts, JunctionsReal, testing::ValuesIn(extracts()), [](const auto& info) {
  std::string name = std::filesystem::path(info.param).stem().stem().string();
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

}  // namespace
}  // namespace citykiln::roads
