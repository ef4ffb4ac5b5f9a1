// The data of the page as JSON: page.json about the run, and files of records about features.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/contract/findings/assumption.h"
#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/tag_list.h"

namespace citykiln::exporters {

using PageRgb = std::array<double, 3>;

/// A sky that the page offers.
struct PageSky {
  std::string time;        ///< ISO 8601, UTC.
  std::string label;       ///< For people.
  bool is_of_run = false;  ///< True for the time that the run was compiled for.
  bool are_lamps_lit = false;
  std::string file;  ///< The name of its table, relative to the folder of the run.
};

/// The light of a sky, linear RGB, not negative. Radiances are in units of sky::kUnitLuminance_cd_m2:
/// - `light`: irradiance of a surface that faces the sun or, by night, the moon; 0 while that is below the horizon.
/// - `disk`: radiance of the disk of sun or moon.
/// - `white_ground`, `ground`: radiance of level white ground, and of ground with the sky's albedo.
struct PageSkyTable {
  Vec3 to_light{0, 0, 1};  ///< The direction to sun or moon, unit length.
  PageRgb light{}, disk{}, white_ground{}, ground{};
  /// The radiance of the sky, row by row, at index row * columns + column. A column is the azimuth
  /// (column + 0.5) / columns of a turn, counter-clockwise from east. A row is the direction with
  /// z = (row / (rows - 1))²: the first is the horizon, the last the zenith.
  std::size_t columns = 0, rows = 0;
  std::vector<PageRgb> radiance{};
};

/// The value of a property of a recipe.
using PageValue = std::variant<bool, std::int64_t, double, std::string>;

/// The facts about a feature. Places are in the frame of the tileset's root.
struct FeatureRecord {
  std::string kind{}, name{};
  Vec3 at;            ///< The middle of the object, or of a line; half way up a building.
  double size_m = 0;  ///< The length of the diagonal of its box.
  double height_m = 0;
  map::TagList tags{};
  Assumptions assumed = kNoAssumptions;
  /// The recipe of its first object, by name in the order of the page. Names of lengths end in "_m".
  std::vector<std::pair<std::string, PageValue>> recipe{};
};

using FeatureRecords = std::map<OsmId, FeatureRecord>;

/// The facts about a run in page.json.
struct PageFacts {
  std::string title;
  std::vector<std::string> attributions;
  std::vector<double> levels_m;  ///< Tolerances, finest first.
  Box2 region_m;
  double ground_m = 0;         ///< The mean height of the ground in the tileset's frame.
  double visibility_km = 100;  ///< Distance at which a black object keeps 2 % of its contrast.
  std::size_t lights = 0;      ///< Lamps of a tile that are lights.
  bool has_tags = false;
  std::vector<PageSky> skies;
  std::size_t feature_files = 0;
};

/// Returns page.json: the facts, the names and texts of assumptions and findings, and the number of features by class.
std::string page_json(const PageFacts& facts, const FeatureRecords& records);

/// Returns the table of a sky. Light has four digits, since sky::generate() uses libm. `to_light` is written in full:
/// it has equal bits on every CPU, and the page compares angles of less than 0.3° with it.
std::string sky_json(const PageSkyTable& sky);

/// Returns how many files the records are divided into: one for each 500.
std::size_t feature_file_count(const FeatureRecords& records);
/// Returns the records as the texts of that many files: a record is in the file (number of the id, without sign) modulo
/// (number of files). A file is an object of records by the id, such as "w123".
std::vector<std::string> feature_files(const FeatureRecords& records, std::size_t count);

/// Returns the names as a list of [name, id, class, x, y], sorted by name and id; x and y are whole metres. Names in
/// other languages (name:en, int_name, alt_name …) are rows of their own in runs that keep tags.
std::string names_json(const FeatureRecords& records);

}  // namespace citykiln::exporters
