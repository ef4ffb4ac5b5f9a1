#include "grammars/operations/face_parts.h"

#include <algorithm>

#include "grammars/evaluate.h"
#include "grammars/operations/table.h"

namespace citykiln::grammars {
namespace {

Shape part_shape(const Shape& from, std::vector<Face> faces) {
  Shape part = heir_of(from);
  part.parent_scope = from.scope;
  part.scope = scope_around(faces, faces.size() == 1 ? axes_of(faces.front()) : from.scope.axis, from.scope.origin);
  part.faces = std::move(faces);
  return part;
}

// takes the faces out of `parts`
std::vector<std::vector<Face>> groups_of(std::vector<PartOf>& parts, int selector, bool together) {
  std::vector<std::vector<Face>> groups;
  for (PartOf& part : parts) {
    if (part.selector != selector) continue;
    if (groups.empty() || !together) groups.emplace_back();
    groups.back().push_back(std::move(part.face));
  }
  return groups;
}

}  // namespace

std::vector<Key> keys_of(Execution& execution, const Statement& statement, const char* words) {
  std::vector<Key> keys;
  Context context{execution.run, execution.shape, execution.frame, execution.dice};
  for (const Selector& selector : statement.selectors) {
    Key& key = keys.emplace_back();
    if (selector.key.target == Target::kWord) {
      key.word = selector.key.text;
      if (!is_among(key.word, words))
        execution.run.trouble(selector.place,
                              "'" + statement.name + "' knows no '" + selector.key.text + "'; it knows" + words);
    } else {
      const double index = number_of(evaluate(selector.key, context));
      key.index = static_cast<std::size_t>(std::clamp(index, 0.0, 1e9));
    }
  }
  return keys;
}

void spawn_parts(Execution& execution, const Statement& statement, std::vector<PartOf> parts, Displacement moved) {
  std::vector<Piece> pieces;
  const Shape& from = execution.shape;
  for (std::size_t k = 0; k < statement.selectors.size(); ++k) {
    auto groups = groups_of(parts, static_cast<int>(k), statement.selectors[k].together);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      Piece& piece = pieces.emplace_back(Piece{part_shape(from, std::move(groups[i])), &statement.selectors[k].body});
      piece.shape.in_comp = {static_cast<double>(i), static_cast<double>(groups.size())};
    }
  }
  for (auto& unwanted : groups_of(parts, -1, false)) pieces.push_back({part_shape(from, std::move(unwanted)), nullptr});
  spawn_pieces(execution, std::move(pieces), moved);
}

PlanAxes plan_axes(const Scope& scope, const Face& face) {
  const NearestAxis normal = nearest_axis(scope, normal_of(face));
  if (normal.axis == 1) return {scope.axis[0], scope.axis[2]};
  if (normal.axis == 2) return {scope.axis[0], scope.axis[1] * -1.0};
  return {scope.axis[2], scope.axis[1] * -1.0};
}

}  // namespace citykiln::grammars
