"""The origin of a scene in degrees. The first run sets it; later runs are placed by it, so that they fit."""
import mathutils

from .plane import placement
from .run_folder import RunError

LON, LAT = "citykiln_lon_0", "citykiln_lat_0"
# single precision leaves 8 mm there
FARTHEST_M = 100e3


def place_run(scene, run):
    """The matrix of a run in a scene. Error: it is too far away."""
    x, y, angle = placement(origin_of(scene) or run.origin_deg, run.origin_deg)
    if max(abs(x), abs(y)) > FARTHEST_M:
        raise RunError(f"{run.folder}: lies {max(abs(x), abs(y)) / 1000:.0f} km from the scene's first run, farther than "
                       f"{FARTHEST_M / 1000:.0f} km: import it into a new scene")
    return mathutils.Matrix.Translation((x, y, 0)) @ mathutils.Matrix.Rotation(angle, 4, "Z")


def origin_of(scene):
    """Longitude and latitude; None in a scene without a run."""
    return (scene[LON], scene[LAT]) if LON in scene and LAT in scene else None


def keep_origin(scene, run):
    """The first run that was imported gives the scene its origin."""
    if origin_of(scene) is None:
        scene[LON], scene[LAT] = run.origin_deg
