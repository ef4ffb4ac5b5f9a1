#include "compiler/bake/grove.h"

#include "compiler/bake/merge.h"

namespace citykiln::bake {

// Nodes of a map stay where they are.
Grove::Slot& Grove::slot(const Key& key) const {
  const std::lock_guard lock(mutex_);
  return slots_[key];
}

const PlantShape& Grove::shape(plants::Prototype prototype, double height_m, double tolerance_m) const {
  Slot& slot = this->slot({prototype, height_m, tolerance_m});
  std::call_once(slot.once, [&] {
    const plants::Grown& grown = nursery_.grown(prototype);
    plants::PrototypeMesh plant = plants::prototype_mesh(grown, prototype.species, height_m, tolerance_m);
    for (materials::DressedMesh& dressed : plant.meshes)
      for (Vec3& p : dressed.mesh.positions) p = p * kShape_m;
    slot.shape = {shared_primitives(plant.meshes), std::move(plant.cutout), plant.error_per_m};
  });
  return slot.shape;
}

}  // namespace citykiln::bake
