// Kinds of plants, and what tags say about a plant.
#pragma once

#include <cstdint>
#include <string_view>

namespace citykiln::map {

/// Plants that look alike. Other genera map to the kind they resemble (taxa.inc).
enum class PlantKind : std::uint8_t {
  kUnknown,
  kFruitTree,
  kBeech,
  kBirch,
  kBush,
  kCypress,
  kFir,
  kLime,
  kMaple,
  kOak,
  kPalm,
  kPine,
  kPlane,
  kPoplar,
  kSpruce,
  kWillow,
  kVine,
  kGrass,
  kGrain,
  kMaize,
  kFern,
  kHonda  ///< No genus: Honda's trees, used by RPForest's scenes.
};

enum class LeafType : std::uint8_t { kUnknown, kBroad, kNeedle, kMixed, kPalm };

struct PlantTags {
  PlantKind kind{};
  LeafType leaves{};
  double crown_m = 0;      ///< Crown diameter; 0: unknown.
  double girth_m = 0;      ///< Trunk circumference at breast height; 0: unknown.
  std::uint16_t year = 0;  ///< Year of planting; 0: unknown.
  bool operator==(const PlantTags&) const = default;
};

/// The sides of a street with trees.
enum class TreeSides : std::uint8_t { kNone, kLeft, kRight, kBoth };

/// Returns the kind that the first known word of a text names, in Latin, English, German, French, Spanish or Catalan,
/// in any case. German compounds match by their ending ("Winterlinde"). kUnknown without a known word. O(words · taxa).
PlantKind kind_named(std::string_view text);

}  // namespace citykiln::map
