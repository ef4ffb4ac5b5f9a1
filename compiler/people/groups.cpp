#include "compiler/people/groups.h"

#include "compiler/contract/random_sequence.h"
#include "compiler/people/body.h"

namespace citykiln::people {
namespace {

// Draws of a spot with somebody; those of members follow.
enum : std::uint32_t { kDrawPair, kDrawWalks, kDrawBack, kDrawChild, kDrawMembers };
// Draws of a member.
enum : std::uint32_t { kDrawBody, kDrawTurn, kDrawsOfMember };

constexpr double kHalfPair_m = 0.34, kHalfTalk_m = 0.45;

double walking_share(SpotUse use) {
  switch (use) {
    case SpotUse::kStop:
    case SpotUse::kCrossing:
    case SpotUse::kSeat:
      return 0;
    case SpotUse::kShops:
      return 0.68;
    case SpotUse::kSquare:
      return 0.55;
    default:
      return 0.86;
  }
}

double pair_share(SpotUse use) {
  if (use == SpotUse::kSeat || use == SpotUse::kStop || use == SpotUse::kCrossing) return 0;
  return use == SpotUse::kSquare ? 0.38 : 0.28;
}

// A direction turned by up to some 20 degrees.
Vec2 turned(Vec2 facing, double by) { return unit(facing + left_of(facing) * by); }

struct GroupMaker {
  const Spot& spot;
  RandomSequence draw;

  Member member(std::uint32_t number, Stance stance, Vec2 at, Vec2 facing, bool may_be_child) const {
    const std::uint32_t first = kDrawMembers + number * kDrawsOfMember;
    const double spread = stance == Stance::kWalking ? 0.12 : 0.35;
    return {at, turned(facing, draw.between(-spread, spread, first + kDrawTurn)),
            drawn_body(stance, may_be_child, draw.unit(first + kDrawBody))};
  }

  std::vector<Member> walkers(bool is_pair) const {
    const Vec2 ahead = spot.along * (draw.unit(kDrawBack) < 0.5 ? 1.0 : -1.0);
    if (!is_pair) return {member(0, Stance::kWalking, spot.at, ahead, false)};
    const Vec2 aside = left_of(ahead) * kHalfPair_m;
    return {member(0, Stance::kWalking, spot.at + aside, ahead, false),
            member(1, Stance::kWalking, spot.at - aside, ahead, draw.unit(kDrawChild) < 0.5)};
  }

  // Two who talk, or one who looks at what the spot is before.
  std::vector<Member> standers(bool is_pair) const {
    if (!is_pair) return {member(0, Stance::kStanding, spot.at, spot.towards, false)};
    const Vec2 aside = spot.along * kHalfTalk_m;
    return {member(0, Stance::kStanding, spot.at + aside, spot.along * -1.0, false),
            member(1, Stance::kStanding, spot.at - aside, spot.along, draw.unit(kDrawChild) < 0.3)};
  }
};

}  // namespace

std::vector<Member> members_at(const Spot& spot, std::uint64_t seed) {
  const GroupMaker maker{spot, RandomSequence(seed, spot.key, "group")};
  if (spot.use == SpotUse::kSeat) {
    Member sitting = maker.member(0, Stance::kSitting, spot.at, spot.towards, false);
    sitting.facing = spot.towards;
    return {sitting};
  }
  const bool is_pair = maker.draw.unit(kDrawPair) < pair_share(spot.use);
  return maker.draw.unit(kDrawWalks) < walking_share(spot.use) ? maker.walkers(is_pair) : maker.standers(is_pair);
}

}  // namespace citykiln::people
