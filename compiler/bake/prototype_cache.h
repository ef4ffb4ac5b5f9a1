// What tiles have in common, each made once a run, when the first tile asks for it: the plants' shapes, and textures.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "compiler/bake/baked_tile.h"
#include "compiler/buildings/rulebook.h"
#include "compiler/materials/texture_cache.h"
#include "compiler/plants/prototypes/grown_plant_cache.h"
#include "compiler/plants/prototypes/prototype_mesh.h"

namespace citykiln::bake {

/// Shapes are of plants so tall that packed places, on a grid of 2^-10 m, tell a twig; a power of two, so that scales
/// stay exact.
inline constexpr double kPrototypeHeight_m = 32;

/// What stands in many places, of a plant kPrototypeHeight_m tall.
struct BakedPrototype {
  std::vector<Primitive> primitives;  ///< Empty: the tolerance drops it.
  impostor::Cutout cutout;
  double error_per_m = 0;
};

/// From any thread. Logically const: a shape is a function of the header's texts and what is asked for. Memory: what
/// has been asked for; at 0.02 m some 2 MB a shape.
class PrototypeCache {
 public:
  explicit PrototypeCache(const scene::Header& header)
      : grown_plants_(header.species, month_of(header)),
        textures_(header.seed),
        rulebook_(buildings::parse_rulebook(header.rules)) {}

  /// Of a plant of no more than `height_m`, within the tolerance. As long as the grove is there.
  const BakedPrototype& shape(plants::Prototype prototype, double height_m, double tolerance_m) const;

  const materials::TextureCache& textures() const { return textures_; }

  /// The header's rules, parsed.
  const buildings::Rulebook& rulebook() const { return rulebook_; }

 private:
  using Key = std::tuple<plants::Prototype, double, double>;
  struct Slot {
    std::once_flag once;
    BakedPrototype shape;
  };

  Slot& slot(const Key& key) const;

  plants::GrownPlantCache grown_plants_;
  materials::TextureCache textures_;
  buildings::Rulebook rulebook_;
  mutable std::mutex mutex_;
  mutable std::map<Key, Slot> slots_;
};

}  // namespace citykiln::bake
