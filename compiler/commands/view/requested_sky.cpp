#include "compiler/commands/view/requested_sky.h"

#include "compiler/sky/clouds/read_clouds.h"
#include "compiler/sky/plan.h"

namespace citykiln::commands {

Result<sky::Sky> sky_of(const LoadRequest& request, const std::optional<scene::Header>& header) {
  sky::Sky sky;
  if (header) sky = header->sky;
  if (!header || !request.time.empty()) {
    Result<sky::Sky> planned = sky::plan(header ? header->origin : LonLat{0, 45}, request.time);
    if (!planned) return planned.error();
    planned->turbidity = sky.turbidity, planned->visibility_km = sky.visibility_km;
    planned->ground_albedo = sky.ground_albedo, planned->ground_m = sky.ground_m;
    planned->clouds = std::move(sky.clouds), planned->inside = std::move(sky.inside);
    sky = std::move(*planned);
  }
  sky::set_air(request.air, sky);
  if (!request.clouds.empty()) {
    Result<std::vector<sky::CloudLayer>> layers =
        sky::read_clouds(request.clouds, sky.ground_m, header ? header->seed : 0);
    if (!layers) return layers.error();
    sky.clouds = std::move(*layers);
  }
  return sky;
}

}  // namespace citykiln::commands
