// What the tiles of a run share, made once, when a tile first needs it: meshes of plant prototypes, and textures.
#pragma once

#include <atomic>
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

/// The height of the prototype for plants of at most this height: the next power of two, so that scales are exact, and
/// between 1/2 and 1 for the tallest plant of a tile.
double prototype_height_m(double tallest_m);

/// The mesh of a plant as tall as was asked for.
struct BakedPrototype {
  std::vector<Primitive>
      primitives;                 ///< Empty where the tolerance drops the plant. Uvs lie on the grid of image_uvs.h.
  impostor::SharedCutout cutout;  ///< The leaf atlas, if the primitives show it.
  double error_per_m = 0;         ///< Error of a plant per metre of its height.
};

/// Which grown plants a cache keeps, from which prototypes are made: 2 MB each.
enum class KeptPlants { kAll, kRecent };

/// A thread-safe cache of prototypes. Logically const: a prototype is a function of the header's species and of what is
/// asked for, by exactly which it is kept. Memory: at 0.02 m some 2 MB per prototype.
class PrototypeCache {
 public:
  explicit PrototypeCache(const scene::Header& header, KeptPlants kept = KeptPlants::kAll)
      : kept_(kept),
        month_(month_of(header)),
        grown_plants_(header.species, month_),
        textures_(header.seed),
        rulebook_(buildings::parse_rulebook(header.rules)) {}

  /// The prototype `height_m` tall, for plants of at most that height within the tolerance, both > 0. Lives as long as
  /// the cache.
  const BakedPrototype& prototype(plants::Prototype prototype, double height_m, double tolerance_m) const;

  const materials::TextureCache& textures() const { return textures_; }

  /// Of the meshes of all prototypes that were asked for, none of which is ever freed.
  std::size_t bytes() const { return bytes_; }

  /// The header's rules, parsed.
  const buildings::Rulebook& rulebook() const { return rulebook_; }

 private:
  using Key = std::tuple<plants::Prototype, double, double>;
  struct Slot {
    std::once_flag once;
    BakedPrototype baked;
  };

  struct Leaves {
    plants::LeafAtlas atlas;
    impostor::SharedCutout cutout;
  };

  Slot& slot(const Key& key) const;
  const Leaves& leaves() const;

  KeptPlants kept_;
  plants::Month month_;
  plants::GrownPlantCache grown_plants_;
  mutable std::once_flag leaves_once_;
  mutable Leaves leaves_;
  materials::TextureCache textures_;
  buildings::Rulebook rulebook_;
  mutable std::mutex mutex_;
  mutable std::map<Key, Slot> slots_;
  mutable std::atomic<std::size_t> bytes_ = 0;
};

}  // namespace citykiln::bake
