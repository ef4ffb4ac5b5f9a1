#include "compiler/verify/assumed/copies.h"

#include "compiler/buildings/planning/doors.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/segment.h"

namespace citykiln::verify {

std::string_view kind_of_mesh(std::string_view mesh) {
  const std::size_t end = mesh.find_last_not_of("0123456789");
  const bool is_numbered = end != mesh.npos && end > 0 && end + 1 < mesh.size() && mesh[end] == '_';
  return is_numbered ? mesh.substr(0, end) : mesh;
}

OrientedRect plan_of_copy(const bake::InstancedMesh& mesh, std::size_t copy, Vec3 origin, double edge_m) {
  Box2 box;
  for (const bake::Primitive& primitive : mesh.primitives)
    for (const bake::Float3& p : primitive.positions) box.grow({p[0], p[1]});
  const bake::Float3& offset = mesh.translations[copy];
  const bake::Float4& turn = mesh.rotations[copy];
  const double norm = static_cast<double>(turn[2]) * turn[2] + static_cast<double>(turn[3]) * turn[3];
  const double cos_yaw = (static_cast<double>(turn[3]) * turn[3] - static_cast<double>(turn[2]) * turn[2]) / norm,
               sin_yaw = 2.0 * turn[2] * turn[3] / norm;
  const Vec2 right{cos_yaw, sin_yaw}, middle = box.centre();
  return {.at = in_plan(Vec3{offset[0], offset[1], offset[2]} + origin) + right * middle.x + left_of(right) * middle.y,
          .ahead = left_of(right),
          .length_m = box.height() - 2 * edge_m,
          .width_m = box.width() - 2 * edge_m};
}

Doors doors_of(const scene::Chunk& chunk, double about_m) {
  Doors doors{.at = {}, .grid = {}, .about_m = about_m};
  std::vector<Box2> boxes;
  for (const buildings::Building& building : chunk.buildings)
    for (const Vec2 door : buildings::door_positions(building)) {
      doors.at.push_back(door);
      boxes.push_back(Box2{door, door}.widened(about_m));
    }
  if (!boxes.empty()) doors.grid = grid_of(boxes, 32);
  return doors;
}

bool is_before_door(const OrientedRect& plan, const Doors& doors) {
  if (doors.at.empty()) return false;
  const auto corners = corners_of(plan);
  return any_about(doors.grid, box_of(plan), [&](std::uint32_t i) {
    return distance_to_ring(corners, doors.at[i]) < doors.about_m || winding_number(corners, doors.at[i]) != 0;
  });
}

}  // namespace citykiln::verify
