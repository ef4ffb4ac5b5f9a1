"""The sky of low suns and after sunset, which Blender's sky leaves black at the horizon. Does not need Blender.

Rows: degrees of the sun, and radiance in W/(m2 sr) at the zenith, at the horizon away from the sun and at that towards it; red, green,
blue. Measured on clear skies of `citykiln preview --exposure 1` over the example town, 12 degrees above the horizon."""
import math

ROWS = [
    (-12, (2.9e-06, 7.6e-06, 2.4e-05), (8.5e-06, 1.7e-05, 3.7e-05), (0.00018, 0.00018, 0.0002)),
    (-9.2, (3.0e-05, 8.0e-05, 0.00025), (0.00011, 0.00019, 0.00041), (0.0034, 0.003, 0.0029)),
    (-6, (0.00073, 0.0016, 0.0043), (0.0013, 0.0022, 0.005), (0.058, 0.046, 0.042)),
    (-4.3, (0.0048, 0.0097, 0.0235), (0.007, 0.0123, 0.026), (0.3, 0.21, 0.17)),
    (-3.1, (0.0147, 0.0266, 0.0593), (0.0244, 0.04, 0.0752), (0.82, 0.54, 0.39)),
    (-1.2, (0.062, 0.096, 0.184), (0.14, 0.196, 0.293), (3.3, 2.0, 1.2)),
    (0.1, (0.146, 0.212, 0.375), (0.384, 0.5, 0.66), (8, 4.8, 2.5)),
    (2.8, (0.377, 0.526, 0.847), (1.26, 1.54, 1.75), (21.6, 14, 6.8)),
]
# degrees between which Blender's own sky takes over
BLENDERS_FROM, BLENDERS_WHOLE = 0, 4


def twilight(elevation_deg):
    """Three colours: zenith, away from the sun, towards it."""
    if elevation_deg <= ROWS[0][0]:
        return ROWS[0][1:]
    for low, high in zip(ROWS, ROWS[1:]):
        if elevation_deg <= high[0]:
            share = (elevation_deg - low[0]) / (high[0] - low[0])
            return tuple(tuple(math.exp((1 - share) * math.log(a) + share * math.log(b)) for a, b in zip(x, y))
                         for x, y in zip(low[1:], high[1:]))
    return ROWS[-1][1:]


def share_of_blender(elevation_deg):
    """How much of the sky is Blender's; the rest is twilight()."""
    return min(max((elevation_deg - BLENDERS_FROM) / (BLENDERS_WHOLE - BLENDERS_FROM), 0), 1)
