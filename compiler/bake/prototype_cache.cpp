#include "compiler/bake/prototype_cache.h"

#include <cassert>

#include "compiler/bake/image_uvs.h"
#include "compiler/bake/merge.h"
#include "compiler/cars/car_mesh.h"
#include "compiler/people/body_mesh.h"
#include "compiler/things/generate.h"

namespace citykiln::bake {

double prototype_height_m(double tallest_m) {
  assert(tallest_m > 0);
  double height_m = 1;
  while (height_m < tallest_m) height_m *= 2;
  while (height_m / 2 >= tallest_m) height_m /= 2;
  return height_m;
}

namespace {

template <typename T>
std::size_t trimmed(std::vector<T>& all) {
  all.shrink_to_fit();
  return all.size() * sizeof(T);
}

// Frees what vectors have reserved.
std::size_t trimmed_bytes_of(Primitive& p) {
  return trimmed(p.positions) + trimmed(p.normals) + trimmed(p.colours) + trimmed(p.features) + trimmed(p.triangles) +
         trimmed(p.uvs);
}

}  // namespace

// Nodes of a map stay where they are.
PrototypeCache::Slot& PrototypeCache::slot(const Key& key) const {
  const std::lock_guard lock(mutex_);
  return slots_[key];
}

const PrototypeCache::Leaves& PrototypeCache::leaves() const {
  std::call_once(leaves_once_, [&] {
    leaves_.atlas = plants::leaf_atlas(month_);
    leaves_.cutout = impostor::SharedCutout(std::move(leaves_.atlas.cutout));
  });
  return leaves_;
}

const BakedPrototype& PrototypeCache::prototype(plants::Prototype prototype, double height_m,
                                                double tolerance_m) const {
  assert(height_m > 0 && tolerance_m > 0);
  Slot& slot = this->slot({prototype, height_m, tolerance_m});
  std::call_once(slot.once, [&] {
    std::shared_ptr<const plants::GrownPlant> recent;
    if (kept_ == KeptPlants::kRecent) recent = grown_plants_.grown_or_regrown(prototype);
    const plants::GrownPlant& grown = recent ? *recent : grown_plants_.grown(prototype);
    plants::PrototypeMesh plant =
        plants::prototype_mesh(grown, leaves().atlas, prototype.species, height_m, tolerance_m);
    for (materials::MaterialMesh& dressed : plant.meshes)
      for (Vec3& p : dressed.mesh.positions) p = p * height_m;
    slot.baked.primitives = instanced_primitives(plant.meshes, Layer::kPlants);
    if (plant.shows_leaf_atlas) slot.baked.cutout = leaves().cutout;
    snap_image_uvs(slot.baked.primitives, *slot.baked.cutout);
    slot.baked.error_per_m = plant.error_per_m;
    for (Primitive& primitive : slot.baked.primitives) bytes_ += trimmed_bytes_of(primitive);
  });
  return slot.baked;
}

PrototypeCache::ThingSlot& PrototypeCache::thing_slot(const things::Form& form, double tolerance_m) const {
  const std::lock_guard lock(mutex_);
  return thing_slots_[{form, tolerance_m}];
}

std::vector<things::WireHold> PrototypeCache::wire_holds(const things::Form& form) const {
  const auto kind = kinds_.find(form.kind);
  return kind == kinds_.end() ? std::vector<things::WireHold>() : things::wire_holds(form, kind->second, seed_);
}

const BakedThing& PrototypeCache::thing(const things::Form& form, double tolerance_m) const {
  ThingSlot& slot = thing_slot(form, tolerance_m);
  std::call_once(slot.once, [&] {
    if (const std::optional<people::Body> body = people::body_of(form)) {
      people::BodyMesh person = people::body_mesh(people::look_of(*body, seed_), tolerance_m);
      slot.baked = {instanced_primitives(std::span(&person.mesh, 1), Layer::kProps), person.error_m};
    } else if (std::optional<cars::CarMesh> car = has_own_cars_ ? std::nullopt : cars::car_mesh(form, tolerance_m)) {
      slot.baked = {instanced_primitives(car->meshes, Layer::kProps), car->error_m};
    } else if (const auto kind = kinds_.find(form.kind); kind != kinds_.end()) {
      things::GeneratedThing thing = things::generate(form, kind->second, seed_, is_night_, tolerance_m);
      slot.baked = {instanced_primitives(thing.meshes, Layer::kProps), thing.error_m, std::move(thing.rule_faults)};
    }
    for (Primitive& primitive : slot.baked.primitives) bytes_ += trimmed_bytes_of(primitive);
  });
  return slot.baked;
}

}  // namespace citykiln::bake
