#include "compiler/bake/far/split_edges.h"

#include <algorithm>
#include <map>
#include <utility>

namespace citykiln::bake {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

template <typename T, typename Mean>
void push_mean(std::vector<T>& values, std::uint32_t a, std::uint32_t b, Mean mean) {
  if (values.empty()) return;
  T out = values[a];
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = mean(values[a][i], values[b][i]);
  values.push_back(out);
}

/// Adds vertices in the middle of edges, each once.
class Halver {
 public:
  Halver(Primitive& primitive, const IsLong& is_long) : p_(primitive), is_long_(is_long) {}

  bool is_long(std::uint32_t a, std::uint32_t b) const {
    return is_long_(widened(p_.positions[a]) - widened(p_.positions[b]));
  }

  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] = middles_.try_emplace(std::minmax(a, b), p_.positions.size());
    if (is_new) add_middle(std::min(a, b), std::max(a, b));
    return place->second;
  }

 private:
  void add_middle(std::uint32_t a, std::uint32_t b) {
    const auto mean = [](float u, float v) { return static_cast<float>((double{u} + v) / 2); };
    push_mean(p_.positions, a, b, mean);
    push_mean(p_.uvs, a, b, mean);
    push_mean(p_.colours, a, b,
              [](std::uint8_t u, std::uint8_t v) { return static_cast<std::uint8_t>((u + v + 1) / 2); });
    const Vec3 normal = unit(widened(p_.normals[a]) + widened(p_.normals[b]));
    p_.normals.push_back({static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)});
    if (!p_.features.empty()) p_.features.push_back(std::uint32_t{p_.features[a]});
  }

  Primitive& p_;
  const IsLong& is_long_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

// The triangle divided at the middles of its long edges; empty if none is long.
std::vector<Triangle> divided(Halver& halver, const Triangle& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
    const bool ab = halver.is_long(a, b), bc = halver.is_long(b, c), ca = halver.is_long(c, a);
    if (ab && bc && ca) {
      const std::uint32_t m = halver.middle(a, b), n = halver.middle(b, c), o = halver.middle(c, a);
      return {{a, m, o}, {m, b, n}, {o, n, c}, {m, n, o}};
    }
    if (ab && bc) {
      const std::uint32_t m = halver.middle(a, b), n = halver.middle(b, c);
      return {{m, b, n}, {a, m, n}, {a, n, c}};
    }
    if (ab && !ca) {
      const std::uint32_t m = halver.middle(a, b);
      return {{a, m, c}, {m, b, c}};
    }
  }
  return {};
}

}  // namespace

void split_long_edges(Primitive& primitive, const IsLong& is_long) {
  Halver halver(primitive, is_long);
  std::vector<Triangle> waiting(primitive.triangles.rbegin(), primitive.triangles.rend()), done;
  while (!waiting.empty()) {
    const Triangle triangle = waiting.back();
    waiting.pop_back();
    const std::vector<Triangle> parts = divided(halver, triangle);
    if (parts.empty())
      done.push_back(triangle);
    else
      waiting.insert(waiting.end(), parts.rbegin(), parts.rend());
  }
  primitive.triangles = std::move(done);
}

}  // namespace citykiln::bake
