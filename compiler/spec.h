// The settings of a compile: inputs, bounds, seed, levels, outputs.
//
// Every setting has one name for the command line (--tile 512) and spec.json ("tile": 512). The table behind settings()
// defines them all.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/compression.h"
#include "compiler/contract/layout.h"
#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/contract/split.h"
#include "compiler/contract/target.h"
#include "compiler/contract/tolerance.h"
#include "compiler/map/locate.h"
#include "compiler/scene/scene.h"
#include "compiler/sky/air_settings.h"
#include "compiler/source/raster.h"

namespace citykiln {

/// The default tolerances of the levels of detail, finest first, metres. None is more than five times the one before
/// it, which skirts rely on (bake/skirt.h); triangles fall by at most eight from one to the next.
inline constexpr std::array kDefaultLevels_m = {0.1, 0.5, 1.2, 2.5, 12.5};

/// The files that a run writes into its folder.
struct Outputs {
  std::string folder;
  bool manifest = true;       ///< scene.kiln
  bool glb = true;            ///< glb/<x>_<y>_L<n>.glb
  bool usd = false;           ///< usd/scene.usda and the layers of its tiles
  bool tiles3d = false;       ///< 3dtiles/tileset.json and its contents, on the ellipsoid.
  bool surroundings = false;  ///< The land around the extent as a tile of its own, in glTF and USD.
  std::string geoid;          ///< Of map::read_geoid(); "" where no height of the geoid is given.
  Target target = Target::kGeneric;
  Split split = Split::kLayer;
  Compression compress = Compression::kNone;
  Layout layout = Layout::kEmbedded;
  std::size_t lights = 0;  ///< So many street lamps of each tile, the brightest, are lights of .glb and USD files.
  /// Where one is set, each tile has one level, the finest of a fixed sequence of tolerances within these limits.
  std::optional<std::uint64_t> max_bytes, max_triangles;
  std::vector<double> ladder_m{kDefaultLevels_m.begin(),
                               kDefaultLevels_m.end()};  ///< Tolerances, increasing; level n has the n-th.
};

/// When a run ends with exit code 2.
struct Strictness {
  bool is_on = false;
  std::vector<Code> codes;  ///< Diagnoses that count; none: those of data that was mended or dropped.
};

/// The shape of the world that positions are in.
enum class World { kByOutput, kPlane, kEllipsoid };

struct CompileSpec {
  std::string map_path;
  std::vector<source::RasterSpec> rasters;  ///< At each place the first that covers it is used.
  map::Options map;
  double tile_m = 1024;              ///< A multiple of map::kCell_m.
  std::vector<scene::TileKey> only;  ///< If not empty, only these tiles are compiled.
  std::uint64_t seed = 0;
  std::optional<double> snow_line_m;  ///< Land above it is covered by snow.
  std::string rules_folder;           ///< Rule files that replace shipped ones of the same name; "" for none.
  World world = World::kByOutput;     ///< 3D Tiles are on the ellipsoid, other outputs in the plane.
  std::string time;                   ///< Of the sky, ISO 8601; see sky::plan.
  sky::AirSettings air;
  std::string clouds;  ///< Of sky::read_clouds(); "" for none.
  int threads = 0;     ///< 0: all processors. Does not change outputs.
  Strictness strict;
  Outputs outputs;
};

/// One row of the table of settings.
struct Setting {
  std::string_view name;  ///< "tile"
  /// Format of the value: "M", "W,S,E,N"; empty for a switch, which takes "true" or "false". A switch that can have a
  /// value begins with "[=": "[=CODE,...]".
  std::string_view value;
  std::string_view help;
  bool repeats = false;  ///< May be given several times; the values accumulate.
  Result<Done> (*apply)(CompileSpec& spec, std::string_view text);
};

/// All settings in the order of the help text.
std::span<const Setting> settings();

/// Applies one setting. An error says what value is expected, and not which setting it is; the spec is then unchanged.
Result<Done> apply(const Setting& setting, std::string_view text, CompileSpec& spec);

/// Reads spec.json: an object whose keys are names of settings and whose values are strings, numbers, booleans, or
/// arrays of these. Paths are relative to the working directory. Errors: a missing file, malformed JSON (with line and
/// column), an unknown key, an invalid value.
Result<CompileSpec> read_spec(const std::string& path);

/// Error: the spec has no map or no output folder, or its outputs do not fit their target.
Result<Done> is_complete(const CompileSpec& spec);

/// Error: the world is not that of the outputs, or the geoid's file cannot be read.
Result<Done> fits_world(const CompileSpec& spec);

/// Error: .glb tiles are written, and the target's reader cannot read the compression.
Result<Done> fits_target(const Outputs& outputs);

/// Parses a tolerance above 0 and at most kCoarsest_m: "0.5".
Result<double> parse_tolerance(std::string_view text);
/// Parses increasing tolerances: "0.1,0.5,2.5".
Result<std::vector<double>> parse_ladder(std::string_view text);
/// Parses "3_-2".
Result<scene::TileKey> parse_tile(std::string_view text);
/// Parses "3_-2,0_0" and inserts the tiles into a sorted vector without duplicates.
Result<Done> add_tiles(std::string_view text, std::vector<scene::TileKey>& tiles);
/// Parses a finite number.
Result<double> parse_number(std::string_view text);
/// Parses exactly `count` numbers separated by commas.
Result<std::vector<double>> parse_numbers(std::string_view text, std::size_t count);
/// Parses an integer from `least` to 2^31 - 1.
Result<std::int64_t> parse_whole(std::string_view text, std::int64_t least);

}  // namespace citykiln
