"""The plane of a run: transverse Mercator, WGS84, scale 1 at the origin. Does not need Blender.

Krüger's series to the fourth order of the third flattening (Karney 2011, "Transverse Mercator with an accuracy of a few
nanometers"): exact to a micrometre within 100 km."""
import math

EQUATOR_M, FLATTENING = 6378137.0, 1 / 298.257223563
N = FLATTENING / (2 - FLATTENING)
ECCENTRICITY = math.sqrt(FLATTENING * (2 - FLATTENING))
RADIUS_M = EQUATOR_M / (1 + N) * (1 + N ** 2 / 4 + N ** 4 / 64)
ALPHA = [N / 2 - 2 / 3 * N ** 2 + 5 / 16 * N ** 3 + 41 / 180 * N ** 4,
         13 / 48 * N ** 2 - 3 / 5 * N ** 3 + 557 / 1440 * N ** 4,
         61 / 240 * N ** 3 - 103 / 140 * N ** 4,
         49561 / 161280 * N ** 4]
# of the difference of two points, whose direction is that of north
STEP_DEG = 1e-3


def place_m(origin_deg, lonlat_deg):
    """East and north of a place, in metres of the plane about an origin."""
    x, y = from_equator(lonlat_deg[0] - origin_deg[0], lonlat_deg[1])
    return x, y - from_equator(0, origin_deg[1])[1]


def placement(origin_deg, other_deg):
    """Where the plane about another origin lies in this one: x and y in metres, and the angle to turn it by, counter-clockwise."""
    x, y = place_m(origin_deg, other_deg)
    north_x, north_y = place_m(origin_deg, (other_deg[0], other_deg[1] + STEP_DEG))
    return x, y, math.atan2(-(north_x - x), north_y - y)


def from_equator(lon_deg, lat_deg):
    lam, phi = math.radians((lon_deg + 180) % 360 - 180), math.radians(lat_deg)
    t = math.sinh(math.atanh(math.sin(phi)) - ECCENTRICITY * math.atanh(ECCENTRICITY * math.sin(phi)))
    xi, eta = math.atan2(t, math.cos(lam)), math.atanh(math.sin(lam) / math.sqrt(1 + t * t))
    x = eta + sum(a * math.cos(2 * j * xi) * math.sinh(2 * j * eta) for j, a in enumerate(ALPHA, 1))
    y = xi + sum(a * math.sin(2 * j * xi) * math.cosh(2 * j * eta) for j, a in enumerate(ALPHA, 1))
    return RADIUS_M * x, RADIUS_M * y
