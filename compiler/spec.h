// The request for a compile: inputs, bounds, seed, levels, outputs.
//
// Its settings are the table of settings.h, for the command line (--tile 512) and for spec.json ("tile": 512).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/cars/recipe.h"
#include "compiler/contract/findings/assumption.h"
#include "compiler/contract/findings/report.h"
#include "compiler/contract/layout.h"
#include "compiler/contract/node_split.h"
#include "compiler/contract/result.h"
#include "compiler/contract/system/compression.h"
#include "compiler/contract/target.h"
#include "compiler/contract/tolerance.h"
#include "compiler/edits/edit.h"
#include "compiler/map/locate.h"
#include "compiler/map/plane/cylinder.h"
#include "compiler/map/plane/geoid.h"
#include "compiler/people/recipe.h"
#include "compiler/scene/scene.h"
#include "compiler/sky/air_settings.h"
#include "compiler/sky/clouds/read_clouds.h"
#include "compiler/sky/moment.h"
#include "compiler/source/outline.h"
#include "compiler/source/raster.h"

namespace citykiln {

/// The tolerances of the default levels of detail, finest first, in metres. None is more than five times the one before
/// it, which skirts rely on (bake/ground/skirt.h). Each level has at least an eighth of the triangles of the level
/// before it.
inline constexpr std::array kDefaultLevels_m = {0.1, 0.5, 1.2, 2.5, kCoarsestDefault_m};

/// Whether a run has the land around the extent.
enum class AroundWish : std::uint8_t {
  kWherePossible,  ///< Not inside of a cylinder; nothing is an error.
  kYes,            ///< Asked for; an error inside of a cylinder.
  kNo              ///< Neither in the manifest nor as a file.
};

/// The files that a run writes into its folder.
struct Outputs {
  std::string folder;
  bool manifest = true;                                  ///< scene.kiln
  bool glb = true;                                       ///< glb/<x>_<y>_L<n>.glb
  bool usd = false;                                      ///< usd/scene.usda and the layers of its tiles
  bool tiles3d = false;                                  ///< 3dtiles/tileset.json and its contents, on the ellipsoid
  bool tiles3d_archive = false;                          ///< tileset.3tz: the same as one file
  bool page = false;                                     ///< index.html and page/, which show the tileset in a browser
  AroundWish surroundings = AroundWish::kWherePossible;  ///< The land around the extent as a separate file.
  std::optional<map::GeoidSource> geoid;                 ///< Empty if no height of the geoid is given.
  Target target = Target::kGeneric;
  NodeSplit split = NodeSplit::kLayer;
  std::optional<Compression> compress;  ///< Empty: kLean where the target's reader takes it, else kNone.
  std::optional<Layout> layout;         ///< Empty: that of the target (layout_of).
  std::string materials_folder;         ///< A folder of artists' textures (outputs/material_sets.h); "" for none.
  bool has_fine_textures = false;       ///< Textures of materials with twice as many texels a side.
  std::size_t lights = 0;  ///< The number of street lamps per tile, brightest first, that are lights in .glb and USD.
  /// If one is set, each tile has one level: the finest of a fixed sequence of tolerances that is within these limits.
  std::optional<std::uint64_t> max_bytes, max_triangles;
  std::vector<double> tolerances_m{kDefaultLevels_m.begin(),
                                   kDefaultLevels_m.end()};  ///< The tolerance of each level, increasing.
};

/// True if a run writes a tileset, in any form.
bool has_tileset(const Outputs& outputs);

/// Returns the compression of the meshes in .glb files for a target.
Compression compression_of(const Outputs& outputs, Target target);

/// Returns the place of meshes and images that tiles share: that of the target unless one is given. With max_bytes they
/// are embedded, since the limit is one of lone files.
Layout layout_of(const Outputs& outputs);

/// Decides whether a run ends with exit code 2.
struct Strictness {
  bool is_on = false;
  std::vector<Code> codes;  ///< The diagnoses that cause it; empty: all of data that was mended or dropped.
};

/// The surface on which the outputs are: the plane, the ellipsoid, the inside of a cylinder, or the one that each
/// output needs.
enum class World { kByOutput, kPlane, kEllipsoid, kCylinder };

/// All settings of a compile.
struct CompileSpec {
  std::string map_path;
  std::vector<source::RasterSpec> rasters;  ///< At each place the first heightmap that covers it is used.
  std::optional<edits::Edits> edits;        ///< Mends of the map, made when it has been read; empty: none.
  map::Options map;
  double tile_m = map::kDefaultTile_m;    ///< A multiple of map::kCell_m.
  std::optional<source::Outline> clip{};  ///< Nothing is compiled beyond it.
  std::string area;                       ///< The name of an area of the map that becomes the clip; "" for none.
  std::vector<scene::TileKey> only;       ///< Sorted. If not empty, only these tiles are compiled.
  std::uint64_t seed = 0;
  Assumptions assume = kNamedAssumptions;  ///< The assumptions made where the map is silent.
  std::optional<double> snow_line_m;       ///< Land above it is covered by snow.
  std::string rules_folder;    ///< A folder of rule files that replace shipped ones of the same name; "" for none.
  std::string things_folder;   ///< A folder with a table of things and rule files; "" for none.
  std::string species_folder;  ///< A folder of user-defined species; "" for none.
  bool fill_lots = false;      ///< Houses on residential land without buildings (lots/fill_lots.h).
  std::optional<cars::CarShare> cars;            ///< Parked cars (cars/parked_cars.h). Empty: car_share_of() decides.
  people::PeopleShare people = people::kNobody;  ///< People in the streets (people/people.h).
  scene::ShownRequest shown{};                   ///< Layers, density of woods and lights of the tiles.
  cars::CarShare traffic = cars::kNoCars;        ///< Cars in the lanes of carriageways (cars/moving_cars.h).
  World world = World::kByOutput;   ///< 3D Tiles need the ellipsoid or a cylinder, others the plane or a cylinder.
  map::Cylinder cylinder{};         ///< For World::kCylinder.
  std::optional<sky::Moment> time;  ///< The time of the sky; see sky::plan().
  sky::AirSettings air;
  /// The layers of clouds. Empty: fair weather, which previews show; outputs then have no files of clouds.
  std::optional<std::vector<sky::CloudRequest>> clouds;
  int threads = 0;  ///< 0: all processors. Does not change outputs.
  Strictness strict;
  Outputs outputs;
};

/// Returns the share of parking places with a car: that of the spec, else the usual one if any rows of parked cars are
/// assumed (Assumption::kParking), else none.
cars::CarShare car_share_of(const CompileSpec& spec);

/// Makes an outline the clip of a spec; its box becomes the box to compile if none is given.
void clip_to(source::Outline outline, CompileSpec& spec);

/// Reads spec.json: an object whose keys are names of settings and whose values are strings, numbers, booleans, or
/// arrays of these. Paths are relative to the working directory. Errors: a missing file, malformed JSON (with line and
/// column), an unknown key, an invalid value.
Result<CompileSpec> read_spec(const std::string& path);

/// Checks that the spec is complete. Errors: it has no map or no output folder; those of check_world() and
/// check_target().
Result<Done> check_complete(const CompileSpec& spec);

/// Checks the surface of the outputs. Errors: `world` is not a surface that the outputs can be on; settings that have
/// no meaning inside of a cylinder; the geoid's file cannot be read.
Result<Done> check_world(const CompileSpec& spec);

/// Checks the compression of .glb tiles. Error: the target's reader cannot read it.
Result<Done> check_target(const Outputs& outputs);

}  // namespace citykiln
