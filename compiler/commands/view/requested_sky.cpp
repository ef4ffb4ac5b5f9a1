#include "compiler/commands/view/requested_sky.h"

#include "compiler/sky/plan.h"

namespace citykiln::commands {

sky::Sky sky_of(const LoadRequest& request, const std::optional<scene::Header>& header) {
  sky::Sky sky;
  if (header) sky = header->sky;
  if (!header || request.time) {
    sky::Sky planned = sky::plan(header ? header->origin : LonLat{0, 45}, request.time);
    planned.turbidity = sky.turbidity, planned.visibility_km = sky.visibility_km;
    planned.ground_albedo = sky.ground_albedo, planned.ground_m = sky.ground_m;
    planned.clouds = std::move(sky.clouds), planned.clouds_are_default = sky.clouds_are_default,
    planned.inside = std::move(sky.inside);
    sky = std::move(planned);
  }
  sky::set_air(request.air, sky);
  if (!header) sky.clouds = sky::requested_clouds(sky::fair_clouds(), 0, 0);
  if (request.clouds) sky.clouds = sky::requested_clouds(*request.clouds, sky.ground_m, header ? header->seed : 0);
  return sky;
}

}  // namespace citykiln::commands
