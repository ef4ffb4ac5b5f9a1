// comp: one shape for each face, comp(f), or for each edge, comp(e).
#include <cmath>

#include "grammars/derivation/evaluate.h"
#include "grammars/operations/edges.h"
#include "grammars/operations/face_parts.h"
#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

bool is_vertical(Vec3 normal) { return std::abs(normal.z) < 0.01; }
bool is_level(Vec3 normal) { return std::abs(normal.z) > 0.9999; }

// The tag of a face takes precedence over its direction: a steep roof plane is top.
std::string_view side_of_face(const Scope& scope, const Face& face, Vec3 normal) {
  if (face.tag == FaceTag::kTop) return "top";
  if (face.tag == FaceTag::kBottom) return "bottom";
  const NearestAxis nearest = nearest_axis(scope, normal);
  // in the scope of a horizontal face z is up and y points to the back
  const bool lies = std::abs(scope.axis[1].z) < 0.01 && std::abs(scope.axis[2].z) > 0.9;
  if (lies && nearest.axis == 2) return nearest.against ? "bottom" : "top";
  if (lies && nearest.axis == 1) return nearest.against ? "front" : "back";
  if (nearest.axis == 1) return nearest.against ? "bottom" : "top";
  if (nearest.axis == 2) return nearest.against ? "back" : "front";
  return nearest.against ? "left" : "right";
}

bool is_side(std::string_view side) { return side != "top" && side != "bottom"; }

bool selects_face(std::string_view word, std::string_view side, Vec3 normal, const Face& face) {
  if (word == "all" || word == side) return true;
  if (word == "side") return is_side(side);
  if (word == "vertical") return is_vertical(normal);
  if (word == "horizontal") return is_level(normal);
  if (word == "aslant") return !is_vertical(normal) && !is_level(normal);
  if (word == "inside") return face.tag == FaceTag::kInside;
  if (word == "border") return face.tag == FaceTag::kBorder;
  if (word == "street" || word == "street.front") return face.street && is_side(side);
  if (word == "street.back") return !face.street && is_side(side);
  return false;
}

const char* name_of(FaceTag tag) {
  if (tag == FaceTag::kVertical) return "vertical";
  if (tag == FaceTag::kInside) return "inside";
  return tag == FaceTag::kBorder ? "border" : "";
}

// A selector of the face's tag takes precedence, else the first selector that fits. So gables and rims of eaves are no
// walls, even if `side` comes first.
int selector_of(const std::vector<Key>& keys, const Scope& scope, const Face& face, std::size_t index) {
  const std::string_view own = name_of(face.tag);
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (!own.empty() && !keys[k].index && keys[k].word == own) return static_cast<int>(k);
  const Vec3 normal = normal_of(face);
  const std::string_view side = side_of_face(scope, face, normal);
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (keys[k].index ? *keys[k].index == index : selects_face(keys[k].word, side, normal, face))
      return static_cast<int>(k);
  return -1;
}

constexpr const char* kWords =
    " all front back left right top bottom side vertical horizontal aslant inside border street street.front "
    "street.back ";

}  // namespace

void op_comp(Execution& execution, const Statement& statement, Arguments arguments) {
  if (word_of(arguments[0]) == "e") return comp_edges(execution, statement);
  const std::vector<Key> keys = keys_of(execution, statement, kWords);
  std::vector<PartOf> parts;
  parts.reserve(execution.shape.faces.size());
  const Scope scope = execution.shape.scope;
  for (std::size_t i = 0; i < execution.shape.faces.size(); ++i) {
    const Face& face = execution.shape.faces[i];
    parts.push_back({face, selector_of(keys, scope, face, i)});
  }
  spawn_parts(execution, statement, std::move(parts), {});
}

}  // namespace citykiln::grammars
