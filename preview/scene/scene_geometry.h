// Triangles and sets of instances in one Embree scene, and the surfaces that hits on them give.
#pragma once

#include <memory>
#include <vector>

#include "preview/scene/cell_extent.h"
#include "preview/scene/instance_set.h"
#include "preview/scene/mesh_part.h"

namespace citykiln::preview {

/// The geometry of a scene. Add all parts and sets, then call commit(); the geometry is immutable from then on.
class SceneGeometry {
 public:
  explicit SceneGeometry(RTCDevice device) : device_(device), scene_(rtcNewScene(device)) {}
  ~SceneGeometry() { rtcReleaseScene(scene_); }
  SceneGeometry(const SceneGeometry&) = delete;
  SceneGeometry& operator=(const SceneGeometry&) = delete;

  void add(MeshPart&& part) { parts_.push_back(std::move(part)); }
  InstanceSet& add(std::unique_ptr<InstanceSet> set) { return *sets_.emplace_back(std::move(set)); }
  const std::vector<std::unique_ptr<InstanceSet>>& instance_sets() const { return sets_; }
  /// Builds the hierarchy. O(n log n).
  void commit();

  RTCScene scene() const { return scene_; }
  /// Returns the surface of a hit, in the world's frame. Its normals are not turned towards the ray yet.
  Hit hit_of(const RTCHit& found, const RayFootprint& footprint) const;
  /// Adds the boxes of all triangles and instances to an extent. O(n).
  void add_to(CellExtent& extent) const;
  /// Returns the bytes of corners and instances, without primitives, meshes of instances and Embree's hierarchies.
  std::size_t bytes() const;

 private:
  RTCDevice device_;
  RTCScene scene_;
  std::vector<MeshPart> parts_;                     // geometry ids 0 … n - 1
  std::vector<std::unique_ptr<InstanceSet>> sets_;  // geometry ids n …
};

}  // namespace citykiln::preview
