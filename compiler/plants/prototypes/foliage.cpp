#include "compiler/plants/prototypes/foliage.h"

#include <algorithm>
#include <cmath>

#include "compiler/plants/prototypes/leaf_outlines.h"
#include "compiler/plants/prototypes/sprays.h"

namespace citykiln::plants {
namespace {

using lsystems::FlatPolygon;
using lsystems::Instance;
using materials::Tint;

// Weight of the direction out of the crown in a card's shading normal.
constexpr double kCrownWeight = 0.6;
// Height of the crown's centre between its lowest and highest card.
constexpr double kCentreHeight = 0.4;

// The shade of a turtle colour: 0, 1, or 2 and more.
Tint shaded_by_colour(Tint tint, std::int32_t colour) {
  constexpr std::array kShares = {0.84, 0.92, 1.0};
  const double share = kShares[static_cast<std::size_t>(std::clamp(colour, 0, 2))];
  for (std::size_t c = 0; c < 3; ++c) tint[c] = static_cast<std::uint8_t>(tint[c] * share + 0.5);
  return tint;
}

std::uint8_t spray_number(Foliage& foliage, const std::string& name) {
  const auto known = std::ranges::find(foliage.sprays, name);
  if (known != foliage.sprays.end()) return static_cast<std::uint8_t>(known - foliage.sprays.begin());
  foliage.sprays.push_back(name);
  return static_cast<std::uint8_t>(foliage.sprays.size() - 1);
}

// The kind's name without ~.
std::string kind_name(const lsystems::ModuleKind& kind) { return kind.name.substr(kind.name.find_first_not_of('~')); }

Card card_of(const Instance& instance, double width, Tint tint, std::uint8_t spray) {
  const lsystems::TurtleFrame& f = instance.frame;
  const Vec3 along = f.heading * -instance.size, across = f.left * (instance.size * width);
  return {.corner = f.at - along - across * 0.5,
          .across = across,
          .along = along,
          .normal = f.up,
          .tint = shaded_by_colour(tint, instance.colour),
          .spray = spray};
}

// A card of an area with an axis from stalk to tip along its middle.
Card about_axis(Vec3 stalk, Vec3 tip, Vec3 area) {
  const Vec3 along = stalk - tip;
  const double long_m = length(along);
  if (!(long_m > 0)) return {.corner = stalk, .across = {}, .along = {}, .normal = {0, 0, 1}};
  const Vec3 across = unit(cross(along, area)) * (length(area) / long_m);
  return {.corner = tip - across * 0.5, .across = across, .along = along, .normal = unit(area)};
}

double farthest_corner_m(const Card& card, std::span<const Vec3> corners) {
  double farthest = 0;
  for (const Vec3 corner : corners) farthest = std::max(farthest, distance(card, corner));
  return farthest;
}

// A card of the polygon's area. Its axis joins two corners or midpoints of sides, chosen so that the card is nearest to
// all corners: the long diagonal of a kite, the line between the ends of a piece of a blade.
Card card_of(const FlatPolygon& polygon, std::span<const Vec3> corners, Tint tint, std::uint8_t spray) {
  Vec3 area;
  for (std::size_t i = 1; i < corners.size(); ++i)
    area = area + cross(corners[i - 1] - corners[0], corners[i] - corners[0]) * 0.5;
  std::vector<Vec3> ends(corners.begin(), corners.end());
  for (std::size_t i = 0; i < corners.size(); ++i)
    ends.push_back((corners[i] + corners[(i + 1) % corners.size()]) * 0.5);
  Card best = about_axis(corners[0], corners[0], area);
  double least = 1e300;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Card card = about_axis(ends[j], ends[i], area);
      const double off = farthest_corner_m(card, corners);
      if (area_of(card) > 0 && off < least) best = card, least = off;
    }
  best.tint = shaded_by_colour(tint, polygon.colour), best.spray = spray;
  return best;
}

// The normal at a place of the ellipsoid through it about the crown's centre.
Vec3 out_of(const CentreBounds& crown, Vec3 crown_centre, Vec3 place) {
  const auto part = [](double off, double extent) { return extent > 0 ? off / (extent * extent) : 0; };
  return unit(Vec3{part(place.x - crown_centre.x, crown.high.x - crown.low.x),
                   part(place.y - crown_centre.y, crown.high.y - crown.low.y),
                   part(place.z - crown_centre.z, crown.high.z - crown.low.z)});
}

// Turns the card's front outwards and sets its shading normal.
void face_outwards(Card& card, Vec3 out) {
  Vec3 own = unit(cross(card.along, card.across));
  if (dot(own, out) < 0) card.corner = card.corner + card.across, card.across = card.across * -1, own = own * -1;
  card.normal = unit(own * (1 - kCrownWeight) + out * kCrownWeight);
}

bool have_few_outlines(const lsystems::Skeleton& skeleton) {
  const auto is_outline = [](const FlatPolygon& polygon) { return polygon.count >= kOutlineCorners; };
  return static_cast<std::size_t>(std::ranges::count_if(skeleton.polygons, is_outline)) <= kMostOutlines;
}

}  // namespace

CentreBounds bounds_of(std::span<const Card> cards) {
  CentreBounds bounds;
  for (const Card& card : cards) {
    const Vec3 p = card.centre();
    bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y), std::min(bounds.low.z, p.z)};
    bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y), std::max(bounds.high.z, p.z)};
  }
  return bounds;
}

double area_of(const Card& card) { return length(card.across) * length(card.along); }

double distance(const Card& card, Vec3 place) {
  const Vec3 off = place - card.corner;
  const auto nearest = [&](Vec3 side) {
    const double square = dot(side, side);
    return square > 0 ? std::clamp(dot(off, side) / square, 0.0, 1.0) : 0;
  };
  return length(off - card.across * nearest(card.across) - card.along * nearest(card.along));
}

std::array<Vec3, 4> corners_of(const Card& card) {
  return {card.corner, card.corner + card.along, card.corner + card.along + card.across, card.corner + card.across};
}

Foliage foliage_of(const lsystems::LSystem& system, const lsystems::Skeleton& skeleton, Tint tint) {
  Foliage foliage;
  for (const Instance& instance : skeleton.instances) {
    const std::string name = kind_name(system.kinds[instance.kind]);
    foliage.cards.push_back(card_of(instance, width_of_spray(name), tint, spray_number(foliage, name)));
  }
  const bool shows_outlines = have_few_outlines(skeleton);
  for (const FlatPolygon& polygon : skeleton.polygons) {
    const auto corners = std::span(skeleton.vertices).subspan(polygon.first, polygon.count);
    foliage.cards.push_back(card_of(polygon, corners, tint, spray_number(foliage, "")));
    if (!shows_outlines || corners.size() < kOutlineCorners) continue;
    foliage.cards.back().outline = static_cast<std::int32_t>(foliage.outlines.size());
    foliage.outlines.emplace_back(corners.begin(), corners.end());
  }
  std::erase_if(foliage.cards, [](const Card& card) { return !(area_of(card) > 0); });
  if (foliage.cards.empty()) return foliage;
  const CentreBounds crown = bounds_of(foliage.cards);
  foliage.crown_centre = (crown.low + crown.high) * 0.5;
  foliage.crown_centre.z = crown.low.z + kCentreHeight * (crown.high.z - crown.low.z);
  for (Card& card : foliage.cards) face_outwards(card, out_of(crown, foliage.crown_centre, card.centre()));
  return foliage;
}

}  // namespace citykiln::plants
