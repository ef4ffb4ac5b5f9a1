#include "compiler/buildings/facade_elements.h"

#include <cmath>

#include "compiler/buildings/meshes/terminal_meshes.h"
#include "compiler/buildings/styles/paint_colour.h"
#include "compiler/impostor/impostor.h"

namespace citykiln::buildings {
namespace {

using grammars::Element;
using materials::SurfaceMaterial;

// Faces of equal elements differ by rounding errors.
constexpr double kGrid_m = 0x1p-10;
// Rooms behind panes are less deep, and sills stand out less.
constexpr double kDepth_m = 2;

Vec3 on_grid(Vec3 p) {
  const auto rounded = [](double v) { return std::floor(v / kGrid_m + 0.5) * kGrid_m; };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

// Faces of one surface as one mesh, in the order of surfaces.
std::vector<materials::MaterialMesh> meshes_of_element(const Element& element,
                                                       const std::vector<SurfaceMaterial>& surfaces) {
  std::map<SurfaceMaterial, std::vector<DerivedFace>> faces_of;
  for (const grammars::ElementFace& each : element.faces) {
    grammars::Face face = each.face;
    grammars::each_vertex(face, [](Vec3& p) { p = on_grid(p); });
    faces_of[surfaces[each.appearance]].push_back({std::move(face), 0});
  }
  return meshes_of(faces_of, {}, 0);
}

// Normals show a reveal; the steps of frames are as wide as a texel.
bool has_relief(const Element& element) {
  constexpr double kLeast_m = 0.06;
  Box2 depths;
  for (const grammars::ElementFace& each : element.faces)
    grammars::each_vertex(each.face, [&](Vec3 p) { depths.grow({p.z, 0}); });
  return depths.width() >= kLeast_m;
}

DrawnElement draw(const Element& element, const std::vector<SurfaceMaterial>& surfaces, double texel_m,
                  bool has_slopes) {
  const impostor::View view{.corner = {0, element.height_m, 0},
                            .u = {1, 0, 0},
                            .v = {0, -1, 0},
                            .texel_m = texel_m,
                            .columns = static_cast<std::uint32_t>(element.width_m / texel_m + 0.5),
                            .rows = static_cast<std::uint32_t>(element.height_m / texel_m + 0.5),
                            .before_m = kDepth_m,
                            .behind_m = kDepth_m,
                            .has_slopes = has_slopes};
  impostor::Impostor seen = impostor::render(impostor::model_of(meshes_of_element(element, surfaces)), view);
  if (seen.dominant_share >= 1) return {nullptr, seen.dominant};
  fill_gaps(seen.picture);
  return {impostor::shared(seen.picture), {}};
}

void add_surface(const SurfaceMaterial& surface, std::vector<std::int32_t>& key) {
  key.push_back(static_cast<std::int32_t>(surface.material));
  for (const std::uint8_t part : surface.tint) key.push_back(part);
}

// All that the picture depends on.
std::vector<std::int32_t> key_of(const Element& element, const std::vector<SurfaceMaterial>& surfaces) {
  const auto steps = [](double m) { return static_cast<std::int32_t>(std::floor(m / kGrid_m + 0.5)); };
  std::vector<std::int32_t> key{steps(element.width_m), steps(element.height_m)};
  for (const grammars::ElementFace& each : element.faces) {
    add_surface(surfaces[each.appearance], key);
    key.push_back(static_cast<std::int32_t>(each.face.outer.size()));
    key.push_back(static_cast<std::int32_t>(each.face.holes.size()));
    grammars::each_vertex(each.face, [&](Vec3 p) { key.insert(key.end(), {steps(p.x), steps(p.y), steps(p.z)}); });
  }
  return key;
}

// Adds a rectangle that shows a whole picture.
void add_rectangle(const grammars::Face& face, TexturedFace& textured) {
  const std::array<Vec3, 3> axis = grammars::axes_of(face);
  const Vec3 first = face.outer.front();
  Box2 box;
  for (const Vec3 p : face.outer) box.grow({dot(p - first, axis[0]), dot(p - first, axis[1])});
  const double wide_m = textured.picture->columns * kElementTexel_m, high_m = textured.picture->rows * kElementTexel_m;
  add_face(face, textured.mesh.mesh);
  std::vector<Vec2>& uvs = textured.mesh.uvs;
  for (std::size_t i = uvs.size(); i < textured.mesh.mesh.positions.size(); ++i) {
    const Vec3 v = textured.mesh.mesh.positions[i] - first;
    uvs.push_back(
        {(dot(v, axis[0]) - box.min.x) / box.width() * wide_m, (box.max.y - dot(v, axis[1])) / box.height() * high_m});
  }
}

using FacesOfSurfaces = std::map<SurfaceMaterial, std::vector<DerivedFace>>;

// Adds the detail of an element where its rectangle stands.
void add_detail(const Element& element, const grammars::Face& rectangle, const std::vector<SurfaceMaterial>& surfaces,
                FacesOfSurfaces& faces_of) {
  const std::array<Vec3, 3> axis = grammars::axes_of(rectangle);
  const Vec3 first = rectangle.outer.front();
  Box2 box;
  for (const Vec3 p : rectangle.outer) box.grow({dot(p - first, axis[0]), dot(p - first, axis[1])});
  const double wide = box.width() / element.width_m, high = box.height() / element.height_m;
  for (const grammars::ElementFace& each : element.faces) {
    grammars::Face face = each.face;
    grammars::each_vertex(face, [&](Vec3& p) {
      p = first + axis[0] * (box.min.x + p.x * wide) + axis[1] * (box.min.y + p.y * high) + axis[2] * p.z;
    });
    faces_of[surfaces[each.appearance]].push_back({std::move(face), 0});
  }
}

// Adds an element to a model for texels larger than it: its mean colour, or all detail if some of it emits light.
void add_from_afar(const Element& element, const grammars::Face& rectangle, const impostor::Picture& picture,
                   const std::vector<SurfaceMaterial>& surfaces, FacesOfSurfaces& faces_of) {
  const impostor::Texel texel = mean(picture);
  if (emits(texel)) return add_detail(element, rectangle, surfaces, faces_of);
  const LinearRgb paint{texel.light[0] / 65535.0, texel.light[1] / 65535.0, texel.light[2] / 65535.0};
  faces_of[{materials::Material::kPaint, tint_towards(materials::Material::kPaint, paint)}].push_back({rectangle, 0});
}

}  // namespace

ElementPictures::Slot& ElementPictures::slot_of(const Element& element,
                                                const std::vector<SurfaceMaterial>& surfaces) const {
  Key key = key_of(element, surfaces);
  const std::lock_guard lock(mutex_);
  return slots_[std::move(key)];
}

DrawnElement ElementPictures::drawn(const Element& element, const std::vector<SurfaceMaterial>& surfaces) const {
  Slot& slot = slot_of(element, surfaces);
  std::call_once(slot.fine_once, [&] { slot.fine = draw(element, surfaces, kElementTexel_m, has_relief(element)); });
  return slot.fine;
}

DrawnElement ElementPictures::drawn_coarsely(const Element& element,
                                             const std::vector<SurfaceMaterial>& surfaces) const {
  Slot& slot = slot_of(element, surfaces);
  std::call_once(slot.coarse_once, [&] { slot.coarse = draw(element, surfaces, kCoarseElementTexel_m, false); });
  return slot.coarse;
}

DetailedFacades detailed_facades(const grammars::Derivation& derivation, const ElementPictures* pictures,
                                 NeededModels needed, OsmId feature) {
  const std::vector<SurfaceMaterial> surfaces = surfaces_of(derivation);
  DetailedFacades detailed;
  std::vector<DrawnElement> drawn_elements;
  for (const Element& element : derivation.elements)
    drawn_elements.push_back(pictures->drawn_coarsely(element, surfaces));
  FacesOfSurfaces faces_of = faces_by_surface(derivation), of_elements;
  for (const grammars::Terminal& terminal : derivation.terminals) {
    if (terminal.element == 0) continue;
    const Element& element = derivation.elements[terminal.element - 1];
    const grammars::Face& rectangle = terminal.faces.front();
    const DrawnElement& drawn = drawn_elements[terminal.element - 1];
    if (!drawn.picture) {
      faces_of[drawn.surface].push_back({rectangle, 0});
      continue;
    }
    if (needed.whole) add_from_afar(element, rectangle, impostor::unpacked(*drawn.picture), surfaces, of_elements);
    detailed.elements.push_back({rectangle, drawn.picture});
  }
  if (needed.walls) detailed.walls = impostor::model_of(meshes_of(faces_of, feature, 0));
  if (!needed.whole) return detailed;
  for (auto& [surface, faces] : of_elements) {
    std::vector<DerivedFace>& all = faces_of[surface];
    all.insert(all.end(), std::make_move_iterator(faces.begin()), std::make_move_iterator(faces.end()));
  }
  detailed.whole = impostor::model_of(meshes_of(faces_of, feature, 0));
  return detailed;
}

void add_elements(const grammars::Derivation& derivation, const ElementPictures& pictures, OsmId feature,
                  FacadeMeshes& faces) {
  const std::vector<SurfaceMaterial> surfaces = surfaces_of(derivation);
  std::vector<DrawnElement> drawn;
  for (const Element& element : derivation.elements) drawn.push_back(pictures.drawn(element, surfaces));
  std::map<const impostor::PackedPicture*, std::size_t> textured;
  std::map<SurfaceMaterial, std::vector<DerivedFace>> plain;
  for (const grammars::Terminal& terminal : derivation.terminals) {
    if (terminal.element == 0) continue;
    const DrawnElement& element = drawn[terminal.element - 1];
    if (!element.picture) {
      plain[element.surface].push_back({terminal.faces.front(), terminal.detail_distance_m});
      continue;
    }
    const auto [at, is_new] = textured.try_emplace(element.picture.get(), faces.textured_faces.size());
    if (is_new) faces.textured_faces.push_back(textured_by(element.picture, feature));
    add_rectangle(terminal.faces.front(), faces.textured_faces[at->second]);
  }
  for (materials::MaterialMesh& mesh : meshes_of(plain, feature, 0)) faces.meshes.push_back(std::move(mesh));
}

}  // namespace citykiln::buildings
