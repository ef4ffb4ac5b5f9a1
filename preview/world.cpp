#include "preview/world.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

namespace citykiln::preview {
namespace {

using bake::Primitive;

// What a triangle geometry of Embree was made from. Positions are Embree's copy's source: about the world's origin, or an archetype's own.
struct Geometry {
  const Primitive* primitive;
  std::vector<bake::Float3> positions;
};

// A scene of archetype geometries, and where it stands.
struct Archetype {
  RTCScene scene = nullptr;
  std::vector<Geometry> geometries;
};
struct Standing {
  std::size_t archetype;
  std::array<float, 12> transform;  // column by column, 3 × 4
};

std::vector<bake::Float3> moved(const Primitive& primitive, Vec3 offset) {
  std::vector<bake::Float3> positions;
  positions.reserve(primitive.positions.size());
  for (const bake::Float3& p : primitive.positions)
    positions.push_back({static_cast<float>(p[0] + offset.x), static_cast<float>(p[1] + offset.y), static_cast<float>(p[2] + offset.z)});
  return positions;
}

void attach(RTCDevice device, RTCScene scene, const Geometry& geometry) {
  RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(
      rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(bake::Float3), geometry.positions.size()));
  std::copy_n(geometry.positions.front().data(), geometry.positions.size() * 3, positions);
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, geometry.primitive->triangles.size()));
  std::copy_n(geometry.primitive->triangles.front().data(), geometry.primitive->triangles.size() * 3, indices);
  rtcCommitGeometry(g);
  rtcAttachGeometry(scene, g);
  rtcReleaseGeometry(g);
}

std::array<float, 12> transform_of(const bake::Instanced& instanced, std::size_t i, Vec3 offset) {
  // turned about z: the quaternion is (0, 0, sin half, cos half)
  const float z = instanced.rotations[i][2], w = instanced.rotations[i][3], k = instanced.scales[i];
  const float c = (w * w - z * z) * k, s = 2 * z * w * k;
  const bake::Float3& t = instanced.translations[i];
  return {c, s, 0, -s, c, 0, 0, 0, k, static_cast<float>(t[0] + offset.x), static_cast<float>(t[1] + offset.y), static_cast<float>(t[2] + offset.z)};
}

Vec3 widened(const bake::Float3& v) { return {v[0], v[1], v[2]}; }

Vec3 placed_point(const std::array<float, 12>& t, Vec3 p) {
  return {t[0] * p.x + t[3] * p.y + t[6] * p.z + t[9], t[1] * p.x + t[4] * p.y + t[7] * p.z + t[10], t[2] * p.x + t[5] * p.y + t[8] * p.z + t[11]};
}
Vec3 placed_direction(const std::array<float, 12>& t, Vec3 d) {
  return {t[0] * d.x + t[3] * d.y + t[6] * d.z, t[1] * d.x + t[4] * d.y + t[7] * d.z, t[2] * d.x + t[5] * d.y + t[8] * d.z};
}

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

RTCRay ray_of(Vec3 from, Vec3 direction) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(from.x), ray.org_y = static_cast<float>(from.y), ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(direction.x), ray.dir_y = static_cast<float>(direction.y), ray.dir_z = static_cast<float>(direction.z);
  ray.tnear = 0, ray.tfar = std::numeric_limits<float>::infinity(), ray.mask = 0xffffffffu;
  return ray;
}

}  // namespace

struct World::Scene {
  Vec3 origin;
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene top = rtcNewScene(device);
  std::vector<Geometry> ground;  // everything that is not instanced; geometry ids 0 … n - 1
  std::vector<Archetype> archetypes;
  std::vector<Standing> standing;  // geometry ids n …

  ~Scene() {
    rtcReleaseScene(top);
    for (Archetype& archetype : archetypes) rtcReleaseScene(archetype.scene);
    rtcReleaseDevice(device);
  }

  void add_archetype(const bake::Instanced& instanced) {
    Archetype archetype{rtcNewScene(device), {}};
    for (const Primitive& primitive : instanced.primitives) archetype.geometries.push_back({&primitive, primitive.positions});
    for (const Geometry& geometry : archetype.geometries) attach(device, archetype.scene, geometry);
    rtcCommitScene(archetype.scene);
    archetypes.push_back(std::move(archetype));
  }

  void stand(const Standing& where) {
    RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(g, archetypes[where.archetype].scene);
    rtcSetGeometryTransform(g, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, where.transform.data());
    rtcCommitGeometry(g);
    rtcAttachGeometry(top, g);
    rtcReleaseGeometry(g);
  }

  void add_instances(const bake::Instanced& instanced, Vec3 offset) {
    add_archetype(instanced);
    for (std::size_t i = 0; i < instanced.translations.size(); ++i) standing.push_back({archetypes.size() - 1, transform_of(instanced, i, offset)});
  }

  Hit hit_of(const RTCRayHit& found, Vec3 direction) const;
};

World::World(std::span<const bake::BakedTile> tiles, Vec3 origin) : scene_(std::make_unique<Scene>()) {
  Scene& s = *scene_;
  s.origin = origin;
  for (const bake::BakedTile& tile : tiles)
    for (const Primitive& primitive : tile.primitives)
      if (!primitive.triangles.empty()) s.ground.push_back({&primitive, moved(primitive, tile.origin - origin)});
  for (const Geometry& geometry : s.ground) attach(s.device, s.top, geometry);
  for (const bake::BakedTile& tile : tiles)
    for (const bake::Instanced& instanced : tile.instanced) s.add_instances(instanced, tile.origin - origin);
  for (const Standing& where : s.standing) s.stand(where);
  rtcCommitScene(s.top);
}
World::~World() = default;
World::World(World&&) noexcept = default;
Vec3 World::origin() const { return scene_->origin; }

Hit World::Scene::hit_of(const RTCRayHit& found, Vec3 direction) const {
  const bool is_instance = found.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
  const Standing* where = is_instance ? &standing[found.hit.instID[0] - ground.size()] : nullptr;
  const Geometry& geometry = is_instance ? archetypes[where->archetype].geometries[found.hit.geomID] : ground[found.hit.geomID];
  const Primitive& primitive = *geometry.primitive;
  const auto& t = primitive.triangles[found.hit.primID];
  const double u = found.hit.u, v = found.hit.v, w = 1 - u - v;
  const auto mixed = [&](const auto& values) { return widened(values[t[0]]) * w + widened(values[t[1]]) * u + widened(values[t[2]]) * v; };
  Hit hit;
  const Vec3 edge1 = widened(geometry.positions[t[1]]) - widened(geometry.positions[t[0]]), edge2 = widened(geometry.positions[t[2]]) - widened(geometry.positions[t[0]]);
  hit.position = mixed(geometry.positions);
  hit.geometric_normal = cross(edge1, edge2);
  hit.shading_normal = mixed(primitive.normals);
  if (is_instance) {
    hit.position = placed_point(where->transform, hit.position);
    hit.geometric_normal = placed_direction(where->transform, hit.geometric_normal);
    hit.shading_normal = placed_direction(where->transform, hit.shading_normal);
  }
  hit.geometric_normal = unit(hit.geometric_normal), hit.shading_normal = unit(hit.shading_normal);
  if (dot(hit.geometric_normal, direction) > 0) hit.geometric_normal = hit.geometric_normal * -1;
  if (dot(hit.shading_normal, hit.geometric_normal) < 0) hit.shading_normal = hit.shading_normal * -1;
  const materials::MaterialValues& values = values_of(primitive.material);
  hit.material = primitive.material, hit.roughness = values.roughness, hit.distance_m = found.ray.tfar;
  for (int c = 0; c < 3; ++c) hit.albedo[c] = values.base_colour[c] * static_cast<float>(primitive.colours[t[0]][c]) / 255.0f;
  return hit;
}

std::optional<Hit> World::first_hit(Vec3 from, Vec3 direction) const {
  if (!is_finite(from) || !is_finite(direction)) return std::nullopt;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit found{ray_of(from, direction), {}};
  found.hit.geomID = found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->top, &context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return scene_->hit_of(found, direction);
}

bool World::is_blocked(Vec3 from, Vec3 direction) const {
  if (!is_finite(from) || !is_finite(direction)) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = ray_of(from, direction);
  rtcOccluded1(scene_->top, &context, &ray);
  return ray.tfar < 0;
}

Vec3 leave(const Hit& hit, Vec3 direction) {
  // Positions are rounded to float32 when the ray is made: half a unit in the last place of the largest coordinate, a few times for the triangle's own
  // corners and the hit's barycentrics (Wächter, Binder, "A fast and robust method for avoiding self-intersection", Ray Tracing Gems, 2019, argue alike).
  constexpr double kRoundings = 8;
  const double largest = std::max({std::abs(hit.position.x), std::abs(hit.position.y), std::abs(hit.position.z), 1.0});
  const double off = kRoundings * largest * 0x1p-24;
  return hit.position + hit.geometric_normal * (dot(direction, hit.geometric_normal) > 0 ? off : -off);
}

}  // namespace citykiln::preview
