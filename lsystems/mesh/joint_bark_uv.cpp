#include "lsystems/mesh/joint_bark_uv.h"

#include <algorithm>
#include <cmath>

namespace citykiln::lsystems {
namespace {

double fraction(double u) { return u - std::floor(u); }

// The turn at which u is continuous through the joint: opposite to side 0, whose stem takes the difference in periods.
constexpr double kOpposite = 0.625;

// Makes the wraps below and above continuous at kOpposite.
void lay_through(BarkWrap& below, BarkWrap& above) {
  above.at = below.u(kOpposite) - above.per_turn * kOpposite;
  const double whole = kFirstU - std::floor(std::min(below.at, above.at));
  below.at += whole, above.at += whole;
}

}  // namespace

BarkWrap continue_wrap(const BarkWrap& arriving, double turn, double per_turn) {
  const double at = arriving.u(turn + kOpposite) - per_turn * kOpposite;
  return {per_turn, kFirstU + fraction(at)};
}

JointBarkUv joint_bark_uv(const Joint& joint, const std::array<BarkWrap, 2 + kMostSideStems>& wrap) {
  JointBarkUv bark{joint, wrap};
  lay_through(bark.wrap[0], bark.wrap[1]);
  std::size_t s = 2;
  for (int side = 0; side < 4; ++side) {
    if ((joint.open >> side & 1) == 0) continue;
    const int next = (side + 1) % 4;
    const Vec3 middle = (joint.box[side] + joint.box[next] + joint.box[4 + side] + joint.box[4 + next]) * 0.25;
    bark.sleeve_m[s] = length(joint.rings[s].at - middle), ++s;
  }
  return bark;
}

Vec2 JointBarkUv::at(const JointStencils::Vertex& vertex) const {
  const auto [turn, v] = vertex.uv;
  if (vertex.uv_stem != 0) {
    const auto s = static_cast<std::size_t>(vertex.uv_stem);
    return {wrap[s].u(turn), joint.rings[s].along_m - (1 - v) * sleeve_m[s]};
  }
  const double share = std::clamp((v - kBoxLow) / (kBoxHigh - kBoxLow), 0.0, 1.0);
  const double low_m = joint.rings[0].along_m;
  return {std::lerp(wrap[0].u(turn), wrap[1].u(turn), share), low_m + v * (joint.rings[1].along_m - low_m)};
}

}  // namespace citykiln::lsystems
