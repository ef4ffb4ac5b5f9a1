// All settings of an invented world, with their names in invent.json.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/invent/country/country_settings.h"
#include "compiler/invent/country/spawn_plants.h"
#include "compiler/invent/land/terrain_settings.h"
#include "compiler/invent/write/world_place.h"

namespace citykiln::invent {

enum class WorldKind : std::uint8_t { kVillage, kTown, kCity, kTiles, kForest };

/// Returns "village", "town", "city", "tiles" or "forest".
std::string_view name_of(WorldKind kind);
std::optional<WorldKind> world_kind_named(std::string_view name);

struct TileSettings {
  double fixed_share = 0.02;  ///< The share of cells that noise fixes first.
  double noise_m = 480;       ///< The size of districts.
};

struct InventSettings {
  WorldKind kind = WorldKind::kTown;
  std::uint64_t seed = 1;
  double side_m = 1024;  ///< The mapped square: a multiple of kSideStep_m.
  LonLat place{12.3, 48.7};
  TerrainSettings terrain;
  CountrySettings country;
  TileSettings tiles;
  Spot spot;
  std::vector<Spawner> spawners;
};

/// Sides are multiples of it, and at most kMostSide_m.
inline constexpr double kSideStep_m = 256, kMostSide_m = 65536;

/// Returns the settings that a kind of world has if none are given.
InventSettings usual_settings(WorldKind kind);

/// One setting of a section of invent.json.
struct NamedSetting {
  std::string_view section, name;
  std::variant<double*, int*, bool*, std::string*> value;
  double low = 0, high = 0;  ///< The range of numbers.
};

/// Returns all settings in sections. The pointers lead into `settings`.
std::vector<NamedSetting> named_settings(InventSettings& settings);

/// Returns the settings of one spawner.
std::vector<NamedSetting> named_settings(Spawner& spawner);

/// Returns a side rounded up to a multiple of kSideStep_m.
double whole_side_m(double side_m);

/// Settings of the command line, which go before those of a file.
struct AskedSettings {
  std::optional<WorldKind> kind;
  std::optional<std::uint64_t> seed;
  std::optional<double> side_m;
  std::optional<LonLat> place;
};

/// Reads the text of invent.json: an object with "kind", "seed", "size", "place" and sections. Settings that are left
/// out are those of the kind. Errors name the file and the place: malformed JSON, an unknown key, a value of another
/// kind or outside its range.
/// @param text  "" for no file.
Result<InventSettings> read_invent_settings(const std::string& text, const std::string& where,
                                            const AskedSettings& asked);

/// Returns all settings as the text of invent.json, which read_invent_settings() reads to equal settings.
std::string text_of(const InventSettings& settings);

}  // namespace citykiln::invent
