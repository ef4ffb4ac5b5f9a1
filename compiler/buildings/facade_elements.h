// Elements of facades on an atlas: a window, door or shop front that a level shows as one rectangle
// (grammars/derivation/element.h) gets a picture of all its detail.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "compiler/buildings/facade_textures.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/material_mesh.h"
#include "grammars/derivation/derive.h"

namespace citykiln::buildings {

/// The side of a texel on the pictures of elements, metres: kElementStep_m is six texels. Frames are three texels wide.
inline constexpr double kElementTexel_m = grammars::kElementStep_m / 6;

/// An element as seen straight on.
struct DrawnElement {
  impostor::SharedPicture picture;       ///< Row 0 is the upper edge; null if all of it has one surface.
  materials::SurfaceMaterial surface{};  ///< The surface in this case.
};

/// Pictures of elements, each drawn once. Thread-safe. A picture is a function of the element and its colours alone, so
/// it does not matter which building draws it. Memory: some 10 kB for a window, and 100 kB while a picture is in use.
class ElementPictures {
 public:
  /// Returns an element as drawn. Calls for equal elements return the same picture while one of them is in use.
  /// @param surfaces  By index into Derivation::appearances.
  DrawnElement drawn(const grammars::Element& element, const std::vector<materials::SurfaceMaterial>& surfaces) const;

 private:
  using Key = std::vector<std::int32_t>;  // sizes, materials, tints and coordinates
  struct Slot {
    std::once_flag once;
    DrawnElement kept;  // with a picture only if it cannot be packed
    std::optional<impostor::PackedPicture> packed;
    std::weak_ptr<const impostor::Picture> in_use;
  };
  DrawnElement taken_from(Slot& slot) const;

  mutable std::mutex mutex_;
  mutable std::map<Key, Slot> slots_;
};

/// Adds the rectangles of a derivation's elements: those with a picture as one TexturedFace for each picture, others to
/// meshes of their surface. O(terminals + faces of elements).
void add_elements(const grammars::Derivation& derivation, const ElementPictures& pictures, OsmId feature,
                  FacadeMeshes& faces);

}  // namespace citykiln::buildings
