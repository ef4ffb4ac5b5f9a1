// What a compile is asked to do: inputs, bounds, chance, levels, outputs, and one Options per stage that has any.
//
// Every setting has one name, on the command line (--tile 512) and in spec.json ("tile": 512) alike; the table of
// settings() is the only place that knows them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/contract/tolerance.h"
#include "compiler/map/locate.h"
#include "compiler/scene/scene.h"
#include "compiler/source/raster.h"

namespace citykiln {

/// How meshes are packed in .glb files (exporters/gltf/compression.h).
enum class Compress { kNone, kDraco, kMeshopt };
std::string_view name_of(Compress compress);  ///< "none", "draco", "meshopt": as the setting is written.
Result<Compress> parse_compress(std::string_view text);

/// What a run leaves behind in its folder.
struct Outputs {
  std::string folder;
  bool manifest = true;             ///< scene.kiln
  bool glb = true;                  ///< glb/<x>_<y>_L<n>.glb
  bool instances_as_nodes = false;  ///< A glTF node per plant and lamp, for readers without EXT_mesh_gpu_instancing.
  Compress compress = Compress::kNone;
  std::vector<double> ladder_m{kDefaultLadder_m.begin(),
                               kDefaultLadder_m.end()};  ///< Tolerances, rising; level n is the n-th.
};

struct CompileSpec {
  std::string map_path;
  std::vector<source::RasterSpec> rasters;  ///< Where several cover a place, the first wins.
  map::Options map;
  double tile_m = 1024;              ///< A whole multiple of map::kCell_m.
  std::vector<scene::TileKey> only;  ///< If not empty, only these tiles are compiled.
  std::uint64_t seed = 0;
  std::optional<double> snow_line_m;  ///< Land above it is under snow.
  std::string rules_folder;           ///< Rule files that take the place of those shipped, by name; "" for none.
  std::string time;                   ///< Of the sky, ISO 8601, UTC; see sky::plan.
  int threads = 0;                    ///< 0: as many as the machine has. Never changes a byte.
  bool is_strict = false;             ///< Exit 2 where data was mended or dropped.
  Outputs outputs;
};

/// One thing that can be set.
struct Setting {
  std::string_view name;  ///< "tile"
  std::string_view
      value;  ///< How its value is written: "M", "W,S,E,N"; empty for a switch, which takes "true" or "false".
  std::string_view help;
  bool repeats = false;  ///< May be given several times; the values add up.
  Result<Done> (*apply)(CompileSpec& spec, std::string_view text);
};

/// All settings, in the order in which help lists them.
std::span<const Setting> settings();

/// Sets one. Errors name the setting and what it takes; the spec is then unchanged.
Result<Done> apply(const Setting& setting, std::string_view text, CompileSpec& spec);

/// Reads spec.json: an object whose keys are names of settings; values are texts, numbers, true or false, or arrays of
/// these. Paths are relative to where the program runs. Errors: a missing file, malformed JSON (line, column), an
/// unknown key, a value that does not parse.
Result<CompileSpec> read_spec(const std::string& path);

/// What the spec must hold whatever way it was made: a map, a folder. The error says which is missing.
Result<Done> is_complete(const CompileSpec& spec);

/// "0.02,0.1,0.5": numbers that must rise and be above zero.
Result<std::vector<double>> parse_ladder(std::string_view text);
/// "3_-2".
Result<scene::TileKey> parse_tile(std::string_view text);
/// "3_-2,0_0": adds them to tiles that are sorted, each once.
Result<Done> add_tiles(std::string_view text, std::vector<scene::TileKey>& tiles);
/// A number and nothing else.
Result<double> parse_number(std::string_view text);
/// Exactly `count` numbers with commas between.
Result<std::vector<double>> parse_numbers(std::string_view text, std::size_t count);
/// A whole number of at least `least`.
Result<std::int64_t> parse_whole(std::string_view text, std::int64_t least);

}  // namespace citykiln
