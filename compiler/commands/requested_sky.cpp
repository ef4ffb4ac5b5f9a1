#include "compiler/commands/requested_sky.h"

#include "compiler/sky/plan.h"

namespace citykiln::commands {

Result<sky::Sky> sky_of(const LoadRequest& request, const std::optional<scene::Header>& header) {
  sky::Sky sky;
  if (header) sky = header->sky;
  if (!header || !request.time.empty()) {
    Result<sky::Sky> planned = sky::plan(header ? header->origin : map::LonLat{0, 45}, request.time);
    if (!planned) return planned.error();
    planned->turbidity = sky.turbidity, planned->visibility_km = sky.visibility_km;
    planned->ground_albedo = sky.ground_albedo;
    sky = std::move(*planned);
  }
  sky::set_air(request.air, sky);
  return sky;
}

}  // namespace citykiln::commands
