#include "grammars/operations/face_parts.h"

#include <algorithm>

#include "grammars/derivation/evaluate.h"
#include "grammars/language/operation_table.h"

namespace citykiln::grammars {
namespace {

Shape part_shape(const Shape& from, std::vector<Face> faces) {
  Shape part = inherited_from(from);
  part.parent_scope = from.scope;
  part.scope = scope_around(faces, faces.size() == 1 ? axes_of(faces.front()) : from.scope.axis, from.scope.origin);
  part.faces = std::move(faces);
  return part;
}

std::vector<Face> one_of(Face&& face) {
  std::vector<Face> faces(1);
  faces.front() = std::move(face);
  return faces;
}

// Moves the faces of a selector into new pieces: one for each, or one for all together.
void add_shapes(const Shape& from, std::vector<PartOf>& parts, int selector, bool together, std::vector<Piece>& pieces,
                const Body* body) {
  std::vector<Face> all;
  for (PartOf& part : parts) {
    if (part.selector != selector) continue;
    if (together) {
      all.push_back(std::move(part.face));
    } else {
      pieces.push_back({part_shape(from, one_of(std::move(part.face))), body});
    }
  }
  if (!all.empty()) pieces.push_back({part_shape(from, std::move(all)), body});
}

}  // namespace

std::vector<Key> keys_of(Execution& execution, const Statement& statement, const char* words) {
  std::vector<Key> keys;
  keys.reserve(statement.selectors.size());
  Context context = context_of(execution);
  for (const Selector& selector : statement.selectors) {
    Key& key = keys.emplace_back();
    if (selector.key.target == Target::kWord) {
      key.word = selector.key.text;
      if (!is_among(key.word, words))
        execution.run.warn(selector.position,
                           "'" + statement.name + "' has no selector '" + selector.key.text + "'; selectors:" + words);
    } else {
      const double index = number_of(evaluate(selector.key, context));
      key.index = static_cast<std::size_t>(std::clamp(index, 0.0, 1e9));
    }
  }
  return keys;
}

int index_of(const std::vector<Key>& keys, std::string_view word) {
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (keys[k].word == word) return static_cast<int>(k);
  return -1;
}

Displacement of_cutting(std::span<const Face> faces) {
  double most_m = 0;
  for (const Face& face : faces) most_m = std::max(most_m, bend_m(face));
  return {most_m, most_m};
}

void spawn_parts(Execution& execution, const Statement& statement, std::vector<PartOf> parts, Displacement moved) {
  std::vector<Piece> pieces;
  pieces.reserve(parts.size());
  for (std::size_t k = 0; k < statement.selectors.size(); ++k) {
    const Selector& selector = statement.selectors[k];
    const std::size_t first = pieces.size();
    add_shapes(execution.shape, parts, static_cast<int>(k), selector.together, pieces, &selector.body);
    for (std::size_t i = first; i < pieces.size(); ++i)
      pieces[i].shape.in_comp = {static_cast<double>(i - first), static_cast<double>(pieces.size() - first)};
  }
  add_shapes(execution.shape, parts, -1, false, pieces, nullptr);
  spawn_pieces(execution, std::move(pieces), moved);
}

PlanAxes plan_axes(const Scope& scope, const Face& face) {
  const NearestAxis normal = nearest_axis(scope, normal_of(face));
  if (normal.axis == 1) return {scope.axis[0], scope.axis[2]};
  if (normal.axis == 2) return {scope.axis[0], scope.axis[1] * -1.0};
  return {scope.axis[2], scope.axis[1] * -1.0};
}

}  // namespace citykiln::grammars
