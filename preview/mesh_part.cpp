#include "preview/mesh_part.h"

#include <algorithm>
#include <cmath>

#include "compiler/sky/generate.h"

namespace citykiln::preview {
namespace {

Vec3 widened(const bake::Float3& v) { return {v[0], v[1], v[2]}; }

// How far the plane that Embree computes in single precision lies from the exact one, near the triangle. The normal is
// a cross product of edges, each exact to a rounding: four roundings of |e1||e2|, which counts the more the thinner the
// triangle is, over a reach of the longest edge; twice that for the products after it. A triangle whose bound is larger
// than a few centimetres is a sliver far thinner than a pixel.
double plane_error_m(Vec3 edge1, Vec3 edge2, Vec3 across) {
  constexpr double kRounding = 0x1p-24, kRoundings = 8, kLargest_m = 0.03;
  const double a = length(edge1), b = length(edge2), area = length(across);
  if (!(area > 0)) return kLargest_m;
  return std::min(kRoundings * kRounding * std::max({a, b, length(edge2 - edge1)}) * a * b / area, kLargest_m);
}

Vec2 widened(const bake::Float2& v) { return {v[0], v[1]}; }

// A vector in a triangle's plane as one of its uvs, which change with the place as they do along two edges.
Vec2 in_uvs(Vec3 v, Vec3 edge1, Vec3 edge2, Vec2 uv_edge1, Vec2 uv_edge2) {
  const double aa = dot(edge1, edge1), ab = dot(edge1, edge2), bb = dot(edge2, edge2), area2 = aa * bb - ab * ab;
  if (!(area2 > 0)) return {};
  const double va = dot(v, edge1), vb = dot(v, edge2);
  return uv_edge1 * ((va * bb - vb * ab) / area2) + uv_edge2 * ((vb * aa - va * ab) / area2);
}

// What a beam covers of the sheet: the flatter it comes, the longer.
TextureFootprint patch_of(const MeshPart& part, const std::array<std::uint32_t, 3>& corners, const RTCHit& found,
                          const RayFootprint& beam) {
  constexpr double kFlattest = 0.005;
  const auto at = [&](int i) { return widened(part.corners[corners[i]]); };
  const auto uv = [&](int i) { return widened(part.primitive->uvs[corners[i]]); };
  const Vec3 edge1 = at(1) - at(0), edge2 = at(2) - at(0), normal = unit(cross(edge1, edge2));
  const Vec2 uv_edge1 = uv(1) - uv(0), uv_edge2 = uv(2) - uv(0);
  const double cosine = dot(normal, beam.direction);
  const Vec3 along =
      unit(beam.direction - normal * cosine) * (beam.across_m / 2 / std::max(std::abs(cosine), kFlattest));
  return {uv(0) + uv_edge1 * found.u + uv_edge2 * found.v, in_uvs(along, edge1, edge2, uv_edge1, uv_edge2),
          beam.across_m};
}

// The same where a metre of the surface need not be one of the picture: atlases of several levels in one have texels of
// one size, and plants stand in many.
TextureFootprint patch_in_scale(const MeshPart& part, const std::array<std::uint32_t, 3>& corners, const RTCHit& found,
                                const RayFootprint& beam) {
  TextureFootprint patch = patch_of(part, corners, found, beam);
  const auto at = [&](int i) { return widened(part.corners[corners[i]]); };
  const auto uv = [&](int i) { return widened(part.primitive->uvs[corners[i]]); };
  const double area = length(cross(at(1) - at(0), at(2) - at(0)));
  const double of_picture = std::abs(cross(uv(1) - uv(0), uv(2) - uv(0)));
  if (area > 0) patch.across_m *= std::sqrt(of_picture / area);
  return patch;
}

// The normal of the texture, told by its directions over the triangle, instead of the smooth one. Of what is seen from
// behind outwards is there.
void roughen(Hit& hit, const MeshPart& part, const std::array<std::uint32_t, 3>& corners, Vec3 normal,
             Vec3 seen_along) {
  const auto at = [&](int i) { return widened(part.corners[corners[i]]); };
  const auto uv = [&](int i) { return widened(part.primitive->uvs[corners[i]]); };
  const Vec2 uv1 = uv(1) - uv(0), uv2 = uv(2) - uv(0);
  const double turn = cross(uv1, uv2) < 0 ? -1 : 1;
  const Vec3 along_u = ((at(1) - at(0)) * uv2.y - (at(2) - at(0)) * uv1.y) * turn;
  const Vec3 out = unit(hit.shading_normal), u = unit(along_u - out * dot(along_u, out));
  const Vec3 along = u * normal.x - cross(out, u) * (turn * normal.y);
  const bool is_behind = dot(hit.geometric_normal, seen_along) > 0;
  // turned later, as a whole
  hit.shading_normal = unit((is_behind ? along * -1 : along) + out * normal.z);
}

// Leaves let through about as much as they throw back.
double translucency_of(materials::Material material) {
  using materials::Material;
  return material == Material::kBroadLeaf ? 0.8 : material == Material::kNeedleLeaf ? 0.4 : 0;
}

void set_material(Hit& hit, const MeshPart& part, const std::array<std::uint32_t, 3>& corners,
                  const std::array<double, 3>& weights, const RTCHit& found, const RayFootprint& beam) {
  const bake::Primitive& primitive = *part.primitive;
  const materials::MaterialValues& values = values_of(primitive.material);
  const auto& own = values.base_colour;
  std::array<double, 3> colour{own[0], own[1], own[2]};
  if (part.texture != nullptr) colour = part.texture->mean(patch_of(part, corners, found, beam));
  if (part.surface != nullptr) {
    const TextureFootprint patch = patch_in_scale(part, corners, found, beam);
    colour = part.surface->colour(patch);
    if (part.surface->has_normals()) roughen(hit, part, corners, part.surface->normal(patch), {});
  }
  const auto shining = emission_of(primitive.material);
  std::array<double, 3> emission{shining[0], shining[1], shining[2]};
  hit.material = primitive.material;
  hit.roughness = values.roughness;
  if (part.impostor != nullptr) {
    const TextureFootprint patch = patch_in_scale(part, corners, found, beam);
    colour = part.impostor->colour(patch);
    hit.roughness = part.impostor->roughness(patch);
    emission = part.impostor->emission(patch);
    if (part.impostor->has_normals()) roughen(hit, part, corners, part.impostor->normal(patch), {});
  }
  if (part.cutout != nullptr) {
    const TextureFootprint patch = patch_in_scale(part, corners, found, beam);
    colour = part.cutout->colour(patch);
    if (part.cutout->has_normals()) roughen(hit, part, corners, part.cutout->normal(patch), beam.direction);
  }
  hit.translucency = translucency_of(primitive.material);
  for (int c = 0; c < 3; ++c) {
    double tint = 0;
    for (int i = 0; i < 3; ++i) tint += weights[i] * primitive.colours[corners[i]][c];
    hit.albedo[c] = colour[c] * tint / 255;
    hit.emission[c] = emission[c] * (materials::kEmission_cd_m2 / sky::kUnitLuminance_cd_m2);
  }
}

// Of single rays only, which are all that are asked.
void pass_where_nothing_is(const RTCFilterFunctionNArguments* args) {
  const auto& part = *static_cast<const MeshPart*>(args->geometryUserPtr);
  const RTCHit& found = *reinterpret_cast<const RTCHit*>(args->hit);
  const auto& corners = part.primitive->triangles[found.primID];
  const auto uv = [&](int i) { return widened(part.primitive->uvs[corners[i]]); };
  const Vec2 at = uv(0) + (uv(1) - uv(0)) * found.u + (uv(2) - uv(0)) * found.v;
  if (!part.cutout->is_there(at)) args->valid[0] = 0;
}

}  // namespace

MeshPart moved(const bake::Primitive& primitive, Vec3 offset, const MipTexture* texture, const MaterialTexture* surface,
               const FacadeAtlasTexture* impostor, const CutoutTexture* cutout) {
  using materials::ColourSource;
  MeshPart part{&primitive, {}};
  if (primitive.colour_source == ColourSource::kByMarkingAtlas) part.texture = texture;
  if (primitive.colour_source == ColourSource::kByAtlas) part.impostor = impostor;
  if (primitive.colour_source == ColourSource::kByMaterial && !primitive.uvs.empty()) part.surface = surface;
  if (primitive.colour_source == ColourSource::kByCutout) part.cutout = cutout;
  part.corners.reserve(primitive.positions.size() + 1);
  for (const bake::Float3& p : primitive.positions)
    part.corners.push_back({static_cast<float>(p[0] + offset.x), static_cast<float>(p[1] + offset.y),
                            static_cast<float>(p[2] + offset.z)});
  part.corners.push_back({});
  return part;
}

void attach(RTCDevice device, RTCScene scene, const MeshPart& part) {
  const bake::Primitive& primitive = *part.primitive;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, part.corners.data(), 0,
                             sizeof(bake::Float3), primitive.positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, primitive.triangles.data(), 0,
                             sizeof(primitive.triangles[0]), primitive.triangles.size());
  if (part.cutout != nullptr) {
    rtcSetGeometryUserData(geometry, const_cast<MeshPart*>(&part));
    rtcSetGeometryIntersectFilterFunction(geometry, pass_where_nothing_is);
    rtcSetGeometryOccludedFilterFunction(geometry, pass_where_nothing_is);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

Hit hit_on(const MeshPart& part, const RTCHit& found, const RayFootprint& beam) {
  const auto& corners = part.primitive->triangles[found.primID];
  const double u = found.u, v = found.v;
  const std::array<double, 3> weights = {1 - u - v, u, v};
  const Vec3 p = widened(part.corners[corners[0]]);
  const Vec3 edge1 = widened(part.corners[corners[1]]) - p, edge2 = widened(part.corners[corners[2]]) - p;
  const Vec3 across = cross(edge1, edge2);
  Hit hit;
  hit.position = p + edge1 * u + edge2 * v;
  hit.geometric_normal = unit(across);
  for (int i = 0; i < 3; ++i)
    hit.shading_normal = hit.shading_normal + widened(part.primitive->normals[corners[i]]) * weights[i];
  hit.rounding_m = plane_error_m(edge1, edge2, across);
  set_material(hit, part, corners, weights, found, beam);
  return hit;
}

}  // namespace citykiln::preview
