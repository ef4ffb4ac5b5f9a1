#include "compiler/bake/prototype_cache.h"

#include <cassert>

#include "compiler/bake/merge.h"

namespace citykiln::bake {

// Nodes of a map stay where they are.
PrototypeCache::Slot& PrototypeCache::slot(const Key& key) const {
  const std::lock_guard lock(mutex_);
  return slots_[key];
}

const BakedPrototype& PrototypeCache::prototype(plants::Prototype prototype, double height_m,
                                                double tolerance_m) const {
  assert(height_m > 0 && tolerance_m > 0);
  Slot& slot = this->slot({prototype, height_m, tolerance_m});
  std::call_once(slot.once, [&] {
    const plants::GrownPlant& grown = grown_plants_.grown(prototype);
    plants::PrototypeMesh plant = plants::prototype_mesh(grown, prototype.species, height_m, tolerance_m);
    for (materials::MaterialMesh& dressed : plant.meshes)
      for (Vec3& p : dressed.mesh.positions) p = p * kPrototypeHeight_m;
    slot.baked = {instanced_primitives(plant.meshes, Layer::kPlants), std::move(plant.cutout), plant.error_per_m};
  });
  return slot.baked;
}

}  // namespace citykiln::bake
