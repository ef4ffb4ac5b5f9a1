// The 130 cases of github.com/osmcode/osm-testdata. The test.json of a case has the expected areas. Differences and
// their reasons are in osm_testdata_differences.txt, from which the table compiler/source/osm_testdata.md is made.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/compiler/source/extract_text.h"
#include "tests/test_files.h"

namespace citykiln::source {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

using Ring = std::vector<Location>;
/// Outer ring first, then the holes, sorted.
using Polygon = std::vector<Ring>;
/// Sorted. Empty: no area.
using MultiPolygon = std::vector<Polygon>;

struct ExpectedArea {
  MultiPolygon shape;
  std::map<std::string, std::string> tags;
  bool operator==(const ExpectedArea&) const = default;
};
using Areas = std::map<OsmId, ExpectedArea>;

bool is_between(Location a, Location middle, Location b) {
  const auto dx1 = std::int64_t{middle.lon_e7} - a.lon_e7, dy1 = std::int64_t{middle.lat_e7} - a.lat_e7;
  const auto dx2 = std::int64_t{b.lon_e7} - middle.lon_e7, dy2 = std::int64_t{b.lat_e7} - middle.lat_e7;
  return dx1 * dy2 == dy1 * dx2;
}

Ring without_straight_points(const Ring& ring) {
  Ring corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!is_between(ring[(i + ring.size() - 1) % ring.size()], ring[i], ring[(i + 1) % ring.size()]))
      corners.push_back(ring[i]);
  }
  return corners;
}

// Returns a ring that is equal for all rings that enclose the same points: corners only, from the smallest on, towards
// the smaller of its neighbours.
Ring normal(Ring ring) {
  ring = without_straight_points(ring);
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  if (ring.back() < ring[1]) std::reverse(ring.begin() + 1, ring.end());
  return ring;
}

MultiPolygon normal(MultiPolygon shape) {
  for (Polygon& polygon : shape) {
    for (Ring& ring : polygon) ring = normal(std::move(ring));
    std::sort(polygon.begin() + 1, polygon.end());
  }
  std::sort(shape.begin(), shape.end());
  return shape;
}

// "MULTIPOLYGON(((x y,x y),(x y)),((x y)))" or "INVALID"
MultiPolygon parse_wkt(const std::string& wkt) {
  MultiPolygon shape;
  int depth = 0;
  for (std::size_t i = wkt.find('('); i < wkt.size(); ++i) {
    if (wkt[i] == '(') {
      ++depth;
      if (depth == 2) shape.emplace_back();
      if (depth == 3) shape.back().emplace_back();
    } else if (wkt[i] == ')') {
      if (depth == 3) shape.back().back().pop_back();  // the first point again
      --depth;
    } else if (wkt[i] != ',' && wkt[i] != ' ') {
      double lon = 0, lat = 0;
      const char* end = wkt.data() + wkt.size();
      const char* gap = std::from_chars(wkt.data() + i, end, lon).ptr;
      const char* rest = std::from_chars(gap + 1, end, lat).ptr;
      shape.back().back().push_back(
          {static_cast<int>(std::lround(lon * 1e7)), static_cast<int>(std::lround(lat * 1e7))});
      i = static_cast<std::size_t>(rest - wkt.data()) - 1;
    }
  }
  return normal(shape);
}

Areas expected_areas(const json& variant) {
  Areas areas;
  for (const json& area : variant) {
    const std::string wkt = area["wkt"];
    if (wkt == "INVALID") continue;
    const OsmType type = area["from_type"] == "way" ? OsmType::kWay : OsmType::kRelation;
    areas[{type, area["from_id"]}] = {parse_wkt(wkt), area["tags"]};
  }
  return areas;
}

MultiPolygon shape_of(const OsmData& data, const Area& area) {
  MultiPolygon shape;
  for (const AreaRing& ring : data.rings_of(area)) {
    const auto points = data.points_of(ring);
    if (ring.is_outer) shape.emplace_back();
    shape.back().emplace_back(points.begin(), points.end());
  }
  return normal(shape);
}

Areas assembled_areas(const OsmData& data) {
  Areas areas;
  for (const Area& area : data.areas) {
    ExpectedArea& ours = areas[area.from];
    ours.shape = shape_of(data, area);
    for (const Tag& tag : data.tags_of(area.tags)) ours.tags[data.strings[tag.key]] = data.strings[tag.value];
  }
  return areas;
}

struct Case {
  int id = 0;
  fs::path folder;
  json description;
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  const fs::path root = real_data("osm-testdata");
  if (!fs::exists(root)) return cases;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().filename() != "test.json") continue;
    const json description = json::parse(bytes_of(entry.path().string()));
    cases.push_back({description["test_id"], entry.path().parent_path(), description});
  }
  std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return a.id < b.id; });
  return cases;
}

struct Difference {
  std::string ours, why;
};

// Lines "case | variant that we give | why".
std::map<int, Difference> known_differences() {
  std::map<int, Difference> differences;
  std::ifstream file(source_file("tests/compiler/source/osm_testdata_differences.txt"));
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t first = line.find(" | "), second = line.find(" | ", first + 3);
    differences[std::stoi(line)] = {line.substr(first + 3, second - first - 3), line.substr(second + 3)};
  }
  return differences;
}

// Which of the expectations of test.json we meet: "default" or another, else "none".
std::string variant_met(const Case& c, const Areas& ours) {
  if (!c.description.contains("areas")) return "default";
  const json& variants = c.description["areas"];
  if (ours == expected_areas(variants["default"])) return "default";
  for (const auto& [name, variant] : variants.items()) {
    if (ours == expected_areas(variant)) return name;
  }
  return "none";
}

std::string text_of_areas(const Areas& areas) {
  std::string text;
  for (const auto& [id, area] : areas) {
    text += fmt::format("\n  {}", to_string(id));
    for (const auto& [key, value] : area.tags) text += fmt::format(" {}={}", key, value);
    for (const Polygon& polygon : area.shape) {
      text += "\n   ";
      for (const Ring& ring : polygon) {
        text += " (";
        for (const Location at : ring) text += fmt::format("{},{} ", at.lon_e7, at.lat_e7);
        text += ")";
      }
    }
  }
  return text;
}

void expect_as_known(const Case& c, const std::string& file, const std::map<int, Difference>& known) {
  Report report;
  const Result<OsmData> data = read_osm((c.folder / file).string(), 1, report);
  const auto difference = known.find(c.id);
  const std::string expected = difference == known.end() ? "default" : difference->second.ours;
  if (!data) {
    EXPECT_EQ(expected, "error") << c.id << " " << file << ": " << to_string(data.error());
    return;
  }
  EXPECT_TRUE(report.balances()) << c.id;
  const Areas ours = assembled_areas(*data);
  EXPECT_EQ(variant_met(c, ours), expected)
      << c.id << " " << file << ": " << c.description["description"] << "\n ours:" << text_of_areas(ours)
      << "\n expected: " << c.description.value("areas", json()).dump(1);
}

TEST(OsmTestdataReal, AreasOfAllCasesAreAsExpectedOrExplained) {
  const std::vector<Case> cases = all_cases();
  if (cases.empty()) GTEST_SKIP() << "no osm-testdata in " << real_data();
  EXPECT_EQ(cases.size(), 130u);
  const std::map<int, Difference> known = known_differences();
  for (const Case& c : cases) {
    expect_as_known(c, "data.osm", known);
    if (fs::exists(c.folder / "data.osm.pbf")) expect_as_known(c, "data.osm.pbf", known);
  }
}

// The text as it stands in a cell of a table.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char letter : text) escaped += letter == '|' ? std::string("\\|") : std::string(1, letter);
  return escaped;
}

TEST(OsmTestdataReal, TableOfDifferencesIsUpToDate) {
  const std::vector<Case> cases = all_cases();
  if (cases.empty()) GTEST_SKIP() << "no osm-testdata in " << real_data();
  const std::map<int, Difference> known = known_differences();
  std::string table = bytes_of(source_file("compiler/source/osm_testdata.md"));
  table = table.substr(table.find("| case |"));
  std::string expected = "| case | what it is | what we give | why |\n|--:|---|---|---|\n";
  for (const Case& c : cases) {
    const auto difference = known.find(c.id);
    if (difference == known.end()) continue;
    const std::string description = c.description["description"];
    expected += fmt::format("| {} | {} | {} | {} |\n", c.id, cell(description), difference->second.ours,
                            cell(difference->second.why));
  }
  EXPECT_EQ(table, expected);
}

}  // namespace
}  // namespace citykiln::source
