"""Exposure of a scene as that of `citykiln preview`. Does not need Blender."""
import math

# Degrees of the sun above the horizon, and stops, as in preview/picture/exposure.cpp (adapted_exposure).
ADAPTED = [(-6, 9.4), (-3, 6.5), (-0.8, 4.2), (0, 3.6), (2, 2.6), (5, 1.5), (10, 0.55), (15, 0)]
# Blender's view transforms, the one most like the preview's first, with the stops at which Cycles shows three views of the example
# town by day as bright as the preview: its curve is AgX with more contrast.
TRANSFORMS = {"AgX": -5.0, "Filmic": -4.2}


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
    return TRANSFORMS[transform] + adapted_stops(math.degrees(math.asin(sine)))
