// Data that the tiles of a run share: meshes of plant prototypes, and textures. Each is made when a tile first needs
// it.
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

/// The height of the prototype for plants of at most this height: the next power of two. So scales are exact, and the
/// tallest plant of a tile has a scale between 1/2 and 1.
double prototype_height_m(double tallest_m);

/// The mesh of a plant of one height.
struct BakedPrototype {
  std::vector<Primitive>
      primitives;                 ///< Empty if the plant is below the tolerance. Uvs lie on the grid of image_uvs.h.
  impostor::SharedCutout cutout;  ///< The leaf atlas, if the primitives show it.
  double error_per_m = 0;         ///< Error of a plant per metre of its height.
};

/// The grown plants that a cache keeps, 2 MB each. Prototypes are made from them.
enum class KeptPlants { kAll, kRecent };

/// A thread-safe cache of prototypes. Logically const: a prototype is a function of the header's species and of the
/// arguments of prototype(). Memory: at 0.02 m some 2 MB per prototype.
class PrototypeCache {
 public:
  explicit PrototypeCache(const scene::Header& header, KeptPlants kept = KeptPlants::kAll)
      : kept_(kept),
        month_(month_of(header)),
        grown_plants_(header.species, month_),
        textures_(header.seed),
        rulebook_(buildings::parse_rulebook(header.rules)) {}

  /// The prototype of a height, within the tolerance for plants of at most that height. Both are > 0. It lives as long
  /// as the cache.
  const BakedPrototype& prototype(plants::Prototype prototype, double height_m, double tolerance_m) const;

  const materials::TextureCache& textures() const { return textures_; }

  /// The memory of the meshes of all prototypes made so far, none of which is freed before the cache.
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
