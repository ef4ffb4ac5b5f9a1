"""Exposure of a scene as that of `citykiln preview`. Does not need Blender."""
import math

# Degrees of the sun above the horizon, and stops, as in preview/picture/exposure.cpp (adapted_exposure).
ADAPTED = [(-6, 9.4), (-3, 6.5), (-0.8, 4.2), (0, 3.6), (2, 2.6), (5, 1.5), (10, 0.55), (15, 0)]
# Blender's view transforms, the one most like the preview's first, with two numbers at which Cycles shows three views of the example
# town as bright as the preview: stops by day, and the share of adapted_stops() by dusk. The preview's curve is AgX with more contrast,
# so that dark pictures need less light here.
TRANSFORMS = {"AgX": (-4.45, 0.93), "Filmic": (-4.35, 0.88)}


def adapted_stops(elevation_deg):
    """The stops by which eyes adapt to low suns and twilight; 0 from 15 degrees on."""
    if elevation_deg <= ADAPTED[0][0]:
        return ADAPTED[0][1]
    for (low, low_stops), (high, high_stops) in zip(ADAPTED, ADAPTED[1:]):
        if elevation_deg <= high:
            share = (elevation_deg - low) / (high - low)
            return low_stops + share * (high_stops - low_stops)
    return 0


def exposure_stops(transform, sine):
    """Stops for a view transform and the sine of the sun's elevation."""
    by_day, share = TRANSFORMS[transform]
    return by_day + share * adapted_stops(math.degrees(math.asin(sine)))
