#include "preview/scene/mesh_part.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>
#include <utility>

#include "compiler/sky/generate.h"
#include "preview/scene/face_rectangles.h"

namespace citykiln::preview {
namespace {

// An upper bound of the distance between the plane that Embree computes in single precision and the exact one, near the
// triangle. The normal is a cross product of edges, each exact to a rounding: an error of four roundings of |e1||e2|,
// which matters the more the thinner the triangle is, over the length of the longest edge; twice that for the products
// after it. Triangles whose bound is larger than a few centimetres are slivers far thinner than a pixel.
double plane_error_m(Vec3 edge1, Vec3 edge2, Vec3 across) {
  constexpr double kRounding = 0x1p-24, kRoundings = 8, kLargest_m = 0.03;
  const double a = length(edge1), b = length(edge2), area = length(across);
  if (!(area > 0)) return kLargest_m;
  return std::min(kRoundings * kRounding * std::max({a, b, length(edge2 - edge1)}) * a * b / area, kLargest_m);
}

// Converts a vector in a triangle's plane to uvs, whose change along two edges is known.
Vec2 in_uvs(Vec3 v, Vec3 edge1, Vec3 edge2, Vec2 uv_edge1, Vec2 uv_edge2) {
  const double aa = dot(edge1, edge1), ab = dot(edge1, edge2), bb = dot(edge2, edge2), area2 = aa * bb - ab * ab;
  if (!(area2 > 0)) return {};
  const double va = dot(v, edge1), vb = dot(v, edge2);
  return uv_edge1 * ((va * bb - vb * ab) / area2) + uv_edge2 * ((vb * aa - va * ab) / area2);
}

// A hit triangle: positions and uvs of its corners, and the hit's barycentric coordinates.
struct HitTriangle {
  std::array<Vec3, 3> at;
  std::array<Vec2, 3> uv;
  double u, v;
};

HitTriangle hit_triangle(const MeshPart& part, const RTCHit& found) {
  const auto& corners = part.primitive->triangles[found.primID];
  HitTriangle triangle{{}, {}, found.u, found.v};
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.at[i] = bake::widened(part.corners[corners[i]]);
    triangle.uv[i] = bake::widened(part.primitive->uvs[corners[i]]);
  }
  return triangle;
}

Vec2 uv_at(const HitTriangle& t) { return t.uv[0] + (t.uv[1] - t.uv[0]) * t.u + (t.uv[2] - t.uv[0]) * t.v; }

// The part of an image that a ray covers: the flatter the ray, the longer.
TextureFootprint texture_footprint_of(const HitTriangle& t, const RayFootprint& ray) {
  constexpr double kFlattest = 0.005;
  if (ray.is_scattered) return {uv_at(t), {}, ray.across_m, true};
  const Vec3 edge1 = t.at[1] - t.at[0], edge2 = t.at[2] - t.at[0], normal = unit(cross(edge1, edge2));
  const double cosine = dot(normal, ray.direction);
  const Vec3 along = unit(ray.direction - normal * cosine) * (ray.across_m / 2 / std::max(std::abs(cosine), kFlattest));
  return {uv_at(t), in_uvs(along, edge1, edge2, t.uv[1] - t.uv[0], t.uv[2] - t.uv[0]), ray.across_m, false};
}

// The part of an image that a ray covers, if a metre of the surface need not be a metre of the image: joined atlases of
// several levels have one texel size, and plants have many sizes.
TextureFootprint scaled_footprint_of(const HitTriangle& t, const RayFootprint& ray) {
  TextureFootprint footprint = texture_footprint_of(t, ray);
  const double area = length(cross(t.at[1] - t.at[0], t.at[2] - t.at[0]));
  const double of_image = std::abs(cross(t.uv[1] - t.uv[0], t.uv[2] - t.uv[0]));
  if (area > 0) footprint.across_m *= std::sqrt(of_image / area);
  return footprint;
}

// Replaces the shading normal by that of a normal map, which refers to the directions of u and v on the triangle. From
// behind, `outwards` is towards the ray.
void apply_normal_map(Hit& hit, const HitTriangle& t, Vec3 normal, Vec3 seen_along) {
  const Vec2 uv1 = t.uv[1] - t.uv[0], uv2 = t.uv[2] - t.uv[0];
  const double turn = cross(uv1, uv2) < 0 ? -1 : 1;
  const Vec3 along_u = ((t.at[1] - t.at[0]) * uv2.y - (t.at[2] - t.at[0]) * uv1.y) * turn;
  const Vec3 out = unit(hit.shading_normal), u = unit(along_u - out * dot(along_u, out));
  const Vec3 along = u * normal.x - cross(out, u) * (turn * normal.y);
  const bool is_behind = dot(hit.geometric_normal, seen_along) > 0;
  // World turns the whole normal towards the ray later
  hit.shading_normal = unit((is_behind ? along * -1 : along) + out * normal.z);
}

// Sets colour and normal by an image that has both.
template <typename Texture>
std::array<double, 3> apply_image(Hit& hit, const HitTriangle& t, const TextureFootprint& footprint,
                                  const Texture& image, Vec3 seen_along = {}) {
  if (image.has_normals() && !footprint.is_rough) apply_normal_map(hit, t, image.normal(footprint), seen_along);
  return image.colour(footprint);
}

// Sets roughness too.
std::array<double, 3> apply_material(Hit& hit, const HitTriangle& t, const TextureFootprint& footprint,
                                     const MaterialTexture& texture) {
  if (!footprint.is_rough) hit.roughness = static_cast<float>(texture.roughness(footprint));
  return apply_image(hit, t, footprint, texture);
}

// Sets normal and roughness of the material below markings, and gives their colour its grain. It lies by the plan:
// places on the atlas depend on what else is there. Tiles and cells begin at multiples of the period.
void apply_under_markings(Hit& hit, const HitTriangle& t, TextureFootprint footprint, const MeshPart& part,
                          std::array<double, 3>& colour) {
  constexpr double kPeriod_m = 16;
  if (footprint.is_rough) return;
  const MaterialTexture& texture = *part.material_texture;
  footprint.centre = in_plan(hit.position - part.offset);
  if (texture.has_normals()) apply_normal_map(hit, t, texture.normal(footprint, kPeriod_m), {});
  hit.roughness = static_cast<float>(texture.roughness(footprint, kPeriod_m));
  const auto& own = values_of(texture.texture().material).base_colour;
  const std::array<double, 3> grain = texture.colour(footprint, kPeriod_m);
  for (std::size_t c = 0; c < 3; ++c) colour[c] = std::min(1.0, colour[c] * grain[c] / own[c]);
}

bool is_pane(materials::Material material) {
  using materials::Material;
  return material == Material::kGlass || material == Material::kGlassFacade || material == Material::kBehindGlass;
}

// Reflectances at normal incidence for refractive indices 1.33 and 1.5; a window has two panes with two faces each,
// half of whose light is seen.
float f0_of(materials::Material material) {
  using materials::Material;
  if (is_water(material)) return 0.02f;
  return is_pane(material) ? 0.08f : 0.04f;
}

// Panes on the atlas are smoother than all else there.
constexpr float kRoughestPane = 0.08f;

// Sets roughness, metalness and normal by a picture on the facade atlas, and returns its colour and emission. Where
// the ray meets only glass, the material is glass.
std::pair<std::array<double, 3>, std::array<double, 3>> apply_facade(Hit& hit, const HitTriangle& t,
                                                                     const TextureFootprint& footprint,
                                                                     const FacadeAtlasTexture& atlas,
                                                                     const TexelRectangle& picture) {
  if (atlas.has_normals() && !footprint.is_rough) apply_normal_map(hit, t, atlas.normal(footprint, picture), {});
  std::tie(hit.roughness, hit.metallic) = atlas.surface(footprint, picture);
  if (hit.roughness < kRoughestPane && hit.metallic == 0)
    hit.material = materials::Material::kGlass, hit.f0 = f0_of(hit.material);
  return {atlas.colour(footprint, picture), atlas.emission(footprint, picture)};
}

// Leaves transmit about as much light as they reflect.
double translucency_of(materials::Material material) {
  using materials::Material;
  return material == Material::kBroadLeaf ? 0.8 : material == Material::kNeedleLeaf ? 0.4 : 0;
}

void set_material(Hit& hit, const MeshPart& part, const std::array<double, 3>& weights, const RTCHit& found,
                  const RayFootprint& ray) {
  const bake::Primitive& primitive = *part.primitive;
  const materials::MaterialValues& values = values_of(primitive.material);
  const auto &own = values.base_colour, &emitted = emission_of(primitive.material);
  std::array<double, 3> colour{own[0], own[1], own[2]}, emission{emitted[0], emitted[1], emitted[2]};
  hit.material = primitive.material, hit.roughness = values.roughness, hit.metallic = values.metallic;
  hit.f0 = f0_of(primitive.material);
  if (!primitive.uvs.empty()) {
    const HitTriangle t = hit_triangle(part, found);
    if (part.marking_atlas != nullptr) colour = part.marking_atlas->mean(texture_footprint_of(t, ray));
    const TextureFootprint footprint = scaled_footprint_of(t, ray);
    if (part.marking_atlas != nullptr && part.material_texture != nullptr)
      apply_under_markings(hit, t, footprint, part, colour);
    else if (part.material_texture != nullptr)
      colour = apply_material(hit, t, footprint, *part.material_texture);
    if (part.cutout != nullptr) colour = apply_image(hit, t, footprint, *part.cutout, ray.direction);
    if (part.facade_atlas != nullptr)
      std::tie(colour, emission) = apply_facade(hit, t, footprint, *part.facade_atlas, part.pictures[found.primID]);
  }
  hit.translucency = translucency_of(primitive.material);
  const auto& corners = primitive.triangles[found.primID];
  for (int c = 0; c < 3; ++c) {
    double tint = 0;
    for (int i = 0; i < 3; ++i) tint += weights[i] * primitive.colours[corners[i]][c];
    hit.albedo[c] = colour[c] * tint / 255;
    hit.emission[c] = emission[c] * (materials::kEmission_cd_m2 / sky::kUnitLuminance_cd_m2);
  }
}

// The mean light of a triangle, in the sky's unit: of its material, or of places all over it on the facade atlas.
Rgb mean_emission(const MeshPart& part, std::size_t triangle) {
  constexpr double kUnit = materials::kEmission_cd_m2 / sky::kUnitLuminance_cd_m2;
  const auto& own = emission_of(part.primitive->material);
  if (part.facade_atlas == nullptr || part.primitive->uvs.empty()) return Rgb{own[0], own[1], own[2]} * kUnit;
  constexpr int kPlaces = 8;
  RTCHit found{};
  found.primID = static_cast<unsigned>(triangle);
  const HitTriangle t = hit_triangle(part, found);
  const double across_m = std::sqrt(std::abs(cross(t.uv[1] - t.uv[0], t.uv[2] - t.uv[0]))) / kPlaces;
  Rgb sum{};
  for (int i = 0; i < kPlaces; ++i)
    for (int j = 0; j < kPlaces; ++j) {
      double u = (i + 0.5) / kPlaces, v = (j + 0.5) / kPlaces;
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec2 at = t.uv[0] + (t.uv[1] - t.uv[0]) * u + (t.uv[2] - t.uv[0]) * v;
      sum = sum + part.facade_atlas->emission({at, {}, across_m, false}, part.pictures[triangle]);
    }
  return sum * (kUnit / (kPlaces * kPlaces));
}

bool has_holes(const MeshPart& part) {
  return part.cutout != nullptr || (part.material_texture != nullptr && part.material_texture->has_holes());
}

// Embree's filter of a hit: holes of cutouts and textures are no hits. Called for single rays only.
void pass_holes(const RTCFilterFunctionNArguments* args) {
  const auto& part = *static_cast<const MeshPart*>(args->geometryUserPtr);
  const Vec2 at_m = uv_at(hit_triangle(part, *reinterpret_cast<const RTCHit*>(args->hit)));
  if (!(part.cutout != nullptr ? part.cutout->is_there(at_m) : part.material_texture->is_there(at_m)))
    args->valid[0] = 0;
}

}  // namespace

MeshPart mesh_part_of(const bake::Primitive& primitive, Vec3 offset, const MipTexture* marking_atlas,
                      const MaterialTexture* material_texture, const FacadeAtlasTexture* facade_atlas,
                      const CutoutTexture* cutout) {
  assert(primitive.normals.size() == primitive.positions.size());
  using materials::ColourSource;
  MeshPart part{&primitive, {}};
  part.offset = offset;
  if (primitive.colour_source == ColourSource::kByMarkingAtlas) part.marking_atlas = marking_atlas;
  if (primitive.colour_source == ColourSource::kByAtlas && !primitive.uvs.empty()) part.facade_atlas = facade_atlas;
  if (part.facade_atlas != nullptr) part.pictures = face_rectangles(primitive, facade_atlas->atlas().colour);
  const bool is_on_ground = primitive.colour_source == ColourSource::kByMarkingAtlas;
  if ((is_on_ground || primitive.colour_source == ColourSource::kByMaterial) && !primitive.uvs.empty())
    part.material_texture = material_texture;
  if (primitive.colour_source == ColourSource::kByCutout) part.cutout = cutout;
  part.corners.reserve(primitive.positions.size() + 1);
  for (const bake::Float3& p : primitive.positions)
    part.corners.push_back({static_cast<float>(p[0] + offset.x), static_cast<float>(p[1] + offset.y),
                            static_cast<float>(p[2] + offset.z)});
  part.corners.push_back({});
  return part;
}

void add_emitters(MeshPart& part, std::vector<Emitter>& all) {
  const bake::Primitive& primitive = *part.primitive;
  const bool has_atlas = part.facade_atlas != nullptr && !primitive.uvs.empty();
  if (has_atlas ? !part.facade_atlas->shines() : !emits(primitive.material)) return;
  part.emitters.assign(primitive.triangles.size(), kNoEmitter);
  for (std::size_t i = 0; i < primitive.triangles.size(); ++i) {
    const Rgb radiance = mean_emission(part, i);
    if (luminance(radiance) <= 0) continue;
    const auto& corners = primitive.triangles[i];
    const Vec3 p = bake::widened(part.corners[corners[0]]);
    part.emitters[i] = static_cast<std::uint32_t>(all.size());
    all.push_back(
        {p, bake::widened(part.corners[corners[1]]) - p, bake::widened(part.corners[corners[2]]) - p, radiance});
  }
}

void set_ray(RTCRay& ray, Vec3 from, Vec3 direction) {
  ray.org_x = static_cast<float>(from.x), ray.org_y = static_cast<float>(from.y),
  ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(direction.x), ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
}

void attach(RTCDevice device, RTCScene scene, const MeshPart& part) {
  const bake::Primitive& primitive = *part.primitive;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, part.corners.data(), 0,
                             sizeof(bake::Float3), part.corners.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, primitive.triangles.data(), 0,
                             sizeof(primitive.triangles[0]), primitive.triangles.size());
  if (has_holes(part)) {
    rtcSetGeometryUserData(geometry, const_cast<MeshPart*>(&part));
    rtcSetGeometryIntersectFilterFunction(geometry, pass_holes);
    rtcSetGeometryOccludedFilterFunction(geometry, pass_holes);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

Hit hit_on(const MeshPart& part, const RTCHit& found, const RayFootprint& footprint) {
  const auto& corners = part.primitive->triangles[found.primID];
  const double u = found.u, v = found.v;
  const std::array<double, 3> weights = {1 - u - v, u, v};
  const Vec3 p = bake::widened(part.corners[corners[0]]);
  const Vec3 edge1 = bake::widened(part.corners[corners[1]]) - p, edge2 = bake::widened(part.corners[corners[2]]) - p;
  const Vec3 across = cross(edge1, edge2);
  Hit hit;
  hit.position = p + edge1 * u + edge2 * v;
  hit.geometric_normal = unit(across);
  for (int i = 0; i < 3; ++i)
    hit.shading_normal = hit.shading_normal + bake::widened(part.primitive->normals[corners[i]]) * weights[i];
  hit.rounding_m = plane_error_m(edge1, edge2, across);
  if (!part.emitters.empty()) hit.emitter = part.emitters[found.primID];
  if (part.features != nullptr) hit.feature = (*part.features)[part.primitive->features[corners[0]]];
  set_material(hit, part, weights, found, footprint);
  if (is_pane(hit.material)) hit.shading_normal = out_of_plane(hit.shading_normal, hit.position);
  if (hit.material == materials::Material::kGlass && dot(across, footprint.direction) < 0)
    hit.pane = pane_of({p, p + edge1, p + edge2});
  // the picture of a whole wall shows many rooms
  constexpr double kWidestRoom_m = 6.5;
  if (part.facade_atlas != nullptr && hit.pane && std::max(hit.pane->width_m, hit.pane->height_m) > kWidestRoom_m)
    hit.pane.reset();
  return hit;
}

}  // namespace citykiln::preview
