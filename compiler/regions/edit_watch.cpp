#include "compiler/regions/edit_watch.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "compiler/edits/fits.h"

namespace citykiln::regions {
namespace {

source::Location location_of_place(osmium::Location place) { return {place.x(), place.y()}; }

// An element of an extract, as edits/fits.h needs it.
template <typename Object>
class WatchedElement {
 public:
  WatchedElement(const Object& object, OsmType type) : object_(object), type_(type) {}

  OsmId id() const { return {type_, object_.id()}; }
  bool is_area() const {
    if constexpr (std::is_same_v<Object, osmium::Way>)
      return object_.nodes().size() >= 4 && object_.ends_have_same_id();
    if constexpr (std::is_same_v<Object, osmium::Relation>)
      return object_.tags().has_tag("type", "multipolygon") || object_.tags().has_tag("type", "boundary");
    return false;
  }
  std::optional<std::string_view> value_of(std::string_view key) const {
    const char* value = object_.tags().get_value_by_key(std::string(key).c_str());
    return value == nullptr ? std::nullopt : std::optional<std::string_view>(value);
  }
  template <typename IsWanted>
  bool any_place(IsWanted is_wanted) const {
    if constexpr (std::is_same_v<Object, osmium::Way>)
      return std::any_of(object_.nodes().begin(), object_.nodes().end(), [&](const osmium::NodeRef& node) {
        return node.location().valid() && is_wanted(location_of_place(node.location()));
      });
    else if constexpr (std::is_same_v<Object, osmium::Node>)
      return is_wanted(location_of_place(object_.location()));
    else
      return true;
  }

 private:
  const Object& object_;
  OsmType type_;
};

bool sets_coastline(const edits::Edit& edit) {
  return std::ranges::any_of(edit.changes.set,
                             [](const auto& tag) { return tag.first == "natural" && tag.second == "coastline"; });
}

EditedAs edited_as(const edits::Edit& edit) {
  if (sets_coastline(edit)) return EditedAs::kCoastline;
  return edit.changes.changes_tags() ? EditedAs::kOther : EditedAs::kSame;
}

}  // namespace

EditWatch::EditWatch(const edits::Edits* edits) : edits_(edits) {
  if (edits_ == nullptr) return;
  fitted_.resize(edits_->lines.size());
  for (std::uint32_t line = 0; line < edits_->lines.size(); ++line) {
    const edits::Edit& edit = edits_->lines[line];
    const auto anchor = [&](edits::ConditionKind kind) {
      return std::ranges::find_if(edit.filter, [&](const edits::Condition& condition) {
        return condition.kind == kind && !condition.is_negated;
      });
    };
    if (edit.added) {
      for (const edits::NewPoint& point : edit.added->points)
        if (point.node) wanted_nodes_.insert(*point.node);
    } else if (const auto ids = anchor(edits::ConditionKind::kIds); ids != edit.filter.end()) {
      for (const OsmId id : ids->ids) by_id_[id].push_back(line);
    } else if (const auto tag = anchor(edits::ConditionKind::kTag); tag != edit.filter.end()) {
      by_key_[tag->key].push_back(line);
    } else {
      others_.push_back(line);
    }
  }
}

template <typename Element>
EditedAs EditWatch::see_element(const Element& element, const osmium::TagList& tags) {
  EditedAs as = EditedAs::kSame;
  const auto try_lines = [&](const std::vector<std::uint32_t>& lines) {
    for (const std::uint32_t line : lines) {
      if (!edits::fits(edits_->lines[line], element)) continue;
      fitted_[line] = true;
      as = std::max(as, edited_as(edits_->lines[line]));
    }
  };
  if (!others_.empty()) try_lines(others_);
  if (!by_id_.empty())
    if (const auto found = by_id_.find(element.id()); found != by_id_.end()) try_lines(found->second);
  if (!by_key_.empty())
    for (const osmium::Tag& tag : tags)
      if (const auto found = by_key_.find(std::string_view(tag.key())); found != by_key_.end())
        try_lines(found->second);
  return as;
}

void EditWatch::see_node_id(std::int64_t id) {
  if (wanted_nodes_.contains(id)) seen_nodes_.insert(id);
}

void EditWatch::see(const osmium::Node& node) {
  if (edits_ == nullptr) return;
  see_node_id(node.id());
  // nodes without tags fit by their id alone
  if (!node.tags().empty() || by_id_.contains({OsmType::kNode, node.id()}))
    see_element(WatchedElement(node, OsmType::kNode), node.tags());
}

EditedAs EditWatch::see(const osmium::Way& way) {
  if (edits_ == nullptr) return EditedAs::kSame;
  if (!wanted_nodes_.empty())
    for (const osmium::NodeRef& node : way.nodes()) see_node_id(node.ref());
  return see_element(WatchedElement(way, OsmType::kWay), way.tags());
}

EditedAs EditWatch::see(const osmium::Relation& relation) {
  if (edits_ == nullptr || relation.tags().empty()) return EditedAs::kSame;
  return see_element(WatchedElement(relation, OsmType::kRelation), relation.tags());
}

std::vector<bool> EditWatch::had_effect() const {
  std::vector<bool> effect = fitted_;
  for (std::size_t i = 0; i < effect.size(); ++i) {
    if (!edits_->lines[i].added) continue;
    effect[i] = std::ranges::all_of(edits_->lines[i].added->points, [&](const edits::NewPoint& point) {
      return !point.node || seen_nodes_.contains(*point.node);
    });
  }
  return effect;
}

}  // namespace citykiln::regions
