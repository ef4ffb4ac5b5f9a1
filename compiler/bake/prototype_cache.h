// A cache of data that the tiles of a run share: meshes of plants, and textures. Each is made when a tile first needs
// it. A prototype is one of the few distinct plants of a species; all plants of that kind are scaled copies of its
// mesh.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "compiler/bake/baked_tile.h"
#include "compiler/buildings/facade_elements.h"
#include "compiler/buildings/styles/rulebook.h"
#include "compiler/cars/car_mesh.h"
#include "compiler/materials/texture_cache.h"
#include "compiler/plants/prototypes/grown_plant_cache.h"
#include "compiler/plants/prototypes/prototype_mesh.h"
#include "compiler/things/catalogue.h"
#include "compiler/things/generate.h"

namespace citykiln::bake {

/// The height at which the mesh of a prototype is made, for plants up to `tallest_m`: the next power of two. So scales
/// are exact, and the tallest plant of a tile has a scale above 1/2, at most 1.
double prototype_height_m(double tallest_m);

/// The mesh of a prototype at one height and tolerance.
struct BakedPrototype {
  /// Empty if the plant is below the tolerance. Uvs lie on the grid of image_uvs.h.
  std::vector<Primitive> primitives;
  impostor::SharedCutout cutout;  ///< The leaf atlas, if the primitives show it.
  double error_per_m = 0;         ///< Error of a plant per metre of its height.
};

/// The mesh of a form of things at a tolerance.
struct BakedThing {
  std::vector<Primitive> primitives;  ///< Empty if the thing is below the tolerance, or its rules are missing.
  double error_m = 0;
  std::vector<grammars::RuleFault> rule_faults{};
};

/// The grown plants that a cache keeps for making further meshes.
enum class KeptPlants {
  kAll,    ///< All: 2 MB each.
  kRecent  ///< The last few.
};

/// A thread-safe cache of meshes. Its const functions change only the cache: a mesh is a function of the header's
/// species, things and sky, and of the arguments of prototype() or thing(). Memory: at a tolerance of 0.02 m some 2 MB
/// per mesh.
class PrototypeCache {
 public:
  /// @param own  Textures that replace those of citykiln.
  explicit PrototypeCache(const scene::Header& header, KeptPlants kept = KeptPlants::kAll,
                          std::vector<materials::Texture> own = {})
      : kept_(kept),
        month_(month_of(header)),
        grown_plants_(header.species, month_),
        textures_(header.seed, 1, std::move(own)),
        rulebook_(buildings::parse_rulebook(header.rules)),
        seed_(header.seed),
        is_night_(scene::night_of(header).has_value()),
        kinds_(things::parse_kinds(header.things)) {
    for (const auto& [name, kind] : kinds_) thing_classes_.emplace(name, kind.row.class_name);
    const auto car = kinds_.find(cars::kCar);
    has_own_cars_ = car != kinds_.end() && !car->second.rules.is_shipped;
  }

  /// The mesh of a prototype, within the tolerance when it is scaled to `height_m`. The reference is valid as long as
  /// the cache.
  /// @param height_m, tolerance_m  > 0.
  const BakedPrototype& prototype(plants::Prototype prototype, double height_m, double tolerance_m) const;

  /// The mesh of a form of things, of a person (people::form_of()) or of a car (cars::car_mesh()), within the
  /// tolerance. The reference is valid as
  /// long as the cache.
  const BakedThing& thing(const things::Form& form, double tolerance_m) const;

  /// The places where wires hang on a form of things; none if its rules are missing. Derived at each call.
  std::vector<things::WireHold> wire_holds(const things::Form& form) const;

  /// The header's species, and the shipped ones.
  const plants::SpeciesTable& species() const { return grown_plants_.table(); }

  /// The classes of the header's things.
  const ThingClasses& thing_classes() const { return thing_classes_; }

  const materials::TextureCache& textures() const { return textures_; }

  /// The pictures of windows, doors and shop fronts.
  const buildings::ElementPictures& element_pictures() const { return element_pictures_; }

  /// The memory of all meshes made up to now. None is freed before the cache.
  std::size_t bytes() const { return bytes_; }

  /// The header's rules, parsed.
  const buildings::Rulebook& rulebook() const { return rulebook_; }

 private:
  using Key = std::tuple<plants::Prototype, double, double>;
  /// An entry that the first thread to need it fills.
  struct Slot {
    std::once_flag once;
    BakedPrototype baked;
  };

  struct ThingSlot {
    std::once_flag once;
    BakedThing baked;
  };

  struct Leaves {
    plants::LeafAtlas atlas;
    impostor::SharedCutout cutout;
  };

  Slot& slot(const Key& key) const;
  ThingSlot& thing_slot(const things::Form& form, double tolerance_m) const;
  const Leaves& leaves() const;

  KeptPlants kept_;
  plants::Month month_;
  plants::GrownPlantCache grown_plants_;
  mutable std::once_flag leaves_once_;
  mutable Leaves leaves_;
  materials::TextureCache textures_;
  buildings::Rulebook rulebook_;
  buildings::ElementPictures element_pictures_;
  std::uint64_t seed_;
  bool is_night_;
  things::Kinds kinds_;
  bool has_own_cars_ = false;  // the rules of cars replace car_mesh()
  ThingClasses thing_classes_;
  mutable std::mutex mutex_;
  mutable std::map<Key, Slot> slots_;
  mutable std::map<std::pair<things::Form, double>, ThingSlot> thing_slots_;
  mutable std::atomic<std::size_t> bytes_ = 0;
};

}  // namespace citykiln::bake
