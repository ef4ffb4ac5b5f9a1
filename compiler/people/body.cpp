#include "compiler/people/body.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "compiler/contract/random_sequence.h"

namespace citykiln::people {
namespace {

constexpr std::string_view kPerson = "person";

struct Model {
  Pose pose;
  Figure figure;
  double height_m;
  LegWear legs;
  HairCut hair_cut;
  Bag bag;
  int weight;
};
constexpr auto kModels = std::to_array<Model>({
#define PERSON(pose, figure, height, legs, hair, bag, weight) \
  {Pose::pose, Figure::figure, height, LegWear::legs, HairCut::hair, Bag::bag, weight},
#include "compiler/people/body_models.inc"
#undef PERSON
});
static_assert(kModels.size() == kBodies);
static_assert(std::ranges::max(kModels, {}, &Model::height_m).height_m == kTallestPerson_m);

// The regions of the weights of skin and hair.
enum Region : std::uint8_t { kEurope, kSouth, kMixed, kLatin, kAfrica, kIndia, kEast, kRegions };

template <std::size_t N>
struct Colour {
  std::uint32_t rgb;
  std::array<int, N> weights;
};
// the columns of clothes: the three seasons, then legs
constexpr std::size_t kLegs = 3;
constexpr auto kClothes = std::to_array<Colour<4>>({
#define CLOTHES(name, rgb, warm, mild, cold, legs) {rgb, {warm, mild, cold, legs}},
#include "compiler/people/body_models.inc"
#undef CLOTHES
});
constexpr auto kShoes = std::to_array<Colour<1>>({
#define SHOES(name, rgb, weight) {rgb, {weight}},
#include "compiler/people/body_models.inc"
#undef SHOES
});
constexpr auto kSkins = std::to_array<Colour<kRegions>>({
#define SKIN(name, rgb, ...) {rgb, {__VA_ARGS__}},
#include "compiler/people/body_models.inc"
#undef SKIN
});
constexpr auto kHairs = std::to_array<Colour<kRegions>>({
#define HAIR(name, rgb, ...) {rgb, {__VA_ARGS__}},
#include "compiler/people/body_models.inc"
#undef HAIR
});

// Draws of a body.
enum : std::uint32_t { kDrawTop, kDrawBottom, kDrawSkin, kDrawHair, kDrawShoes, kDrawBag, kDrawCap, kDrawHasCap };

Region region_of(map::CountryGroup country) {
  using enum map::CountryGroup;
  switch (country) {
    case kSouthernEurope:
    case kNorthAfricaAndMiddleEast:
      return kSouth;
    case kNorthAmerica:
    case kOceania:
      return kMixed;
    case kLatinAmerica:
      return kLatin;
    case kTropicalAfrica:
      return kAfrica;
    case kSouthAsia:
      return kIndia;
    case kChina:
    case kJapan:
    case kSouthEastAsia:
      return kEast;
    default:
      return kEurope;
  }
}

materials::Tint tint_of_rgb(std::uint32_t rgb) {
  const auto channel = [&](int shift) {
    // a tint multiplies the reflectance of the material, 0.9
    const double share = materials::linear_of_srgb(static_cast<std::uint8_t>(rgb >> shift & 255)) / 0.9;
    return static_cast<std::uint8_t>(std::min(255.0, share * 255 + 0.5));
  };
  return {channel(16), channel(8), channel(0), 255};
}

// The tint that a number in [0, 1) picks by the weights of a column.
template <typename Colours>
materials::Tint picked_tint(const Colours& colours, std::size_t column, double draw) {
  int sum = 0;
  for (const auto& colour : colours) sum += colour.weights[column];
  double left = draw * sum;
  for (const auto& colour : colours) {
    left -= colour.weights[column];
    if (left < 0) return tint_of_rgb(colour.rgb);
  }
  return tint_of_rgb(colours.back().rgb);
}

Stance stance_of(Pose pose) {
  if (pose == Pose::kWalk) return Stance::kWalking;
  return pose == Pose::kSit ? Stance::kSitting : Stance::kStanding;
}

}  // namespace

std::uint16_t drawn_body(Stance stance, bool with_children, double draw) {
  const auto weight_of = [&](const Model& model) {
    const bool fits = stance_of(model.pose) == stance && (with_children || model.figure != Figure::kChild);
    return fits ? model.weight : 0;
  };
  int sum = 0;
  for (const Model& model : kModels) sum += weight_of(model);
  double left = draw * sum;
  for (std::uint16_t i = 0; i < kBodies; ++i) {
    left -= weight_of(kModels[i]);
    if (left < 0) return i;
  }
  return 0;
}

Look look_of(const Body& body, std::uint64_t seed) {
  const Model& model = kModels[body.number];
  const RandomSequence draw(seed, stable_id(stable_id(ObjectId{}), "person", body.number), "look");
  const Region region = region_of(body.country);
  const auto season = static_cast<std::size_t>(body.season);
  const bool has_cap = body.season == Season::kCold && model.hair_cut != HairCut::kBun && draw.unit(kDrawHasCap) < 0.45;
  Look look{.pose = model.pose,
            .figure = model.figure,
            .height_m = model.height_m,
            .legs = model.legs,
            .hair_cut = model.hair_cut,
            .bag = model.bag,
            .season = body.season,
            .has_cap = has_cap,
            .top = picked_tint(kClothes, season, draw.unit(kDrawTop)),
            .bottom = picked_tint(kClothes, kLegs, draw.unit(kDrawBottom)),
            .skin = picked_tint(kSkins, region, draw.unit(kDrawSkin)),
            .hair = picked_tint(kHairs, region, draw.unit(kDrawHair)),
            .shoes = picked_tint(kShoes, 0, draw.unit(kDrawShoes)),
            .bag_colour = picked_tint(kShoes, 0, draw.unit(kDrawBag)),
            .cap = picked_tint(kClothes, season, draw.unit(kDrawCap))};
  if (look.legs == LegWear::kDress) look.bottom = look.top;
  // bare legs are for warm days
  if (look.season != Season::kWarm && look.legs == LegWear::kShorts) look.legs = LegWear::kTrousers;
  return look;
}

things::Form form_of(const Body& body) {
  return {.kind = std::string(kPerson),
          .width_m = 0.5,
          .depth_m = 0.75,
          .height_m = kModels[body.number].height_m,
          .capacity = body.number,
          .country = body.country,
          .variant = static_cast<std::uint8_t>(body.season)};
}

std::optional<Body> body_of(const things::Form& form) {
  if (form.kind != kPerson || form.capacity >= kBodies) return std::nullopt;
  return Body{form.capacity, form.country, static_cast<Season>(form.variant)};
}

Season season_of(std::uint8_t month) {
  if (month >= 5 && month <= 9) return Season::kWarm;
  return month == 4 || month == 10 ? Season::kMild : Season::kCold;
}

}  // namespace citykiln::people
