#include "compiler/cars/car_models.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <string_view>

#include "compiler/contract/random_sequence.h"
#include "compiler/map/things/thing_role.h"

namespace citykiln::cars {
namespace {

// The regions of the weights.
enum Market : std::uint8_t { kEurope, kAmericas, kAsia, kJapan, kMarkets };
using Weights = std::array<int, kMarkets>;

struct Body {
  std::string_view name;
  double width_m, length_m, height_m;
  Weights weights;
};
constexpr auto kBodies = std::to_array<Body>({
#define CAR_BODY(name, width, length, height, europe, americas, asia, japan) \
  {name, width, length, height, {europe, americas, asia, japan}},
#include "compiler/cars/car_models.inc"
#undef CAR_BODY
});

struct Colour {
  std::uint32_t rgb;
  Weights weights;
};
constexpr auto kColours = std::to_array<Colour>({
#define CAR_COLOUR(name, rgb, europe, americas, asia, japan) {rgb, {europe, americas, asia, japan}},
#include "compiler/cars/car_models.inc"
#undef CAR_COLOUR
});

// Draws of a car.
enum : std::uint32_t { kDrawBody, kDrawColour, kDrawIsWhite };

Market market_of(map::CountryGroup country) {
  using enum map::CountryGroup;
  switch (country) {
    case kNorthAmerica:
    case kLatinAmerica:
    case kOceania:
      return kAmericas;
    case kTropicalAfrica:
    case kSouthAsia:
    case kChina:
    case kSouthEastAsia:
      return kAsia;
    case map::CountryGroup::kJapan:
      return Market::kJapan;
    default:
      return kEurope;
  }
}

// The row that a number in [0, 1) picks by the weights of a market.
template <typename Rows>
const auto& picked(const Rows& rows, Market market, double draw) {
  int sum = 0;
  for (const auto& row : rows) sum += row.weights[market];
  double left = draw * sum;
  for (const auto& row : rows) {
    left -= row.weights[market];
    if (left < 0) return row;
  }
  return rows.back();
}

map::Srgb srgb(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8 & 255),
          static_cast<std::uint8_t>(rgb & 255)};
}

constexpr const Body& kHatchback = kBodies[1];
static_assert(kHatchback.name == "hatchback" && kHatchback.length_m == kLeastPlace_m);

// The body of a draw; that of a hatchback where the place is shorter.
const Body& body_of(const Place& place, double draw) {
  const Body& body = picked(kBodies, market_of(place.country), draw);
  return body.length_m <= place.length_m ? body : kHatchback;
}

const Body& body_named(std::string_view name) { return *std::ranges::find(kBodies, name, &Body::name); }

things::Form form_with(const Body& body, std::uint32_t rgb) {
  return {.kind = std::string(map::name_of(map::ThingRole::kCar)),
          .width_m = body.width_m,
          .depth_m = body.length_m,
          .height_m = body.height_m,
          .value = std::string(body.name),
          .colour = srgb(rgb)};
}

}  // namespace

things::Form form_of_lorry(const Place& place, std::uint64_t seed) {
  const RandomSequence draw(seed, place.key, "car");
  return form_with(body_named("lorry"), picked(kColours, market_of(place.country), draw.unit(kDrawColour)).rgb);
}

things::Form form_of_bus(const Place& place, std::uint64_t seed) {
  // liveries of cities: Berlin, London, green, blue, white with few buses of each
  constexpr std::uint32_t kLiveries[] = {0xe8c21e, 0xb5161b, 0x2f6b45, 0x2a5fa0, 0xdfe2e2, 0xd9e0e4};
  const RandomSequence draw(seed, stable_id(StableId{}, "livery", static_cast<std::uint64_t>(place.country)), "bus");
  return form_with(body_named("bus"), kLiveries[draw.below(std::size(kLiveries), 0)]);
}

things::Form form_of_car(const Place& place, std::uint64_t seed) {
  assert(place.length_m >= kLeastPlace_m);
  const RandomSequence draw(seed, place.key, "car");
  const Body& body = body_of(place, draw.unit(kDrawBody));
  const bool is_van = body.name == "van" || body.name == "minibus";
  const bool is_white = is_van && draw.unit(kDrawIsWhite) < 0.5;
  const Colour& colour = is_white ? kColours[0] : picked(kColours, market_of(place.country), draw.unit(kDrawColour));
  return form_with(body, colour.rgb);
}

}  // namespace citykiln::cars
