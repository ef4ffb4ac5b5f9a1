"""The direction of the sun at a time and a place, within 0.02 degrees from 1950 to 2050. Does not need Blender.

The low precision formulae of the Astronomical Almanac (Michalsky 1988, "The Astronomical Almanac's algorithm for approximate solar
position"), without refraction, as citykiln's manifest has it."""
import math
from datetime import datetime, timezone

J2000 = datetime(2000, 1, 1, 12, tzinfo=timezone.utc)


def sun_direction(year, month, day, hour, lon_deg, lat_deg):
    """A unit vector towards the sun: east, north, up. @param hour  UTC, with its fraction."""
    days = (datetime(year, month, 1, tzinfo=timezone.utc) - J2000).total_seconds() / 86400 + day - 1 + hour / 24
    mean, anomaly = 280.460 + 0.9856474 * days, math.radians(357.528 + 0.9856003 * days)
    longitude = math.radians(mean + 1.915 * math.sin(anomaly) + 0.020 * math.sin(2 * anomaly))
    tilt = math.radians(23.439 - 4e-7 * days)
    ascension = math.atan2(math.cos(tilt) * math.sin(longitude), math.cos(longitude))
    declination = math.asin(math.sin(tilt) * math.sin(longitude))
    sidereal_deg = 280.46062 + 360.98564737 * days
    angle, latitude = math.radians(sidereal_deg + lon_deg) - ascension, math.radians(lat_deg)
    return (-math.cos(declination) * math.sin(angle),
            math.sin(declination) * math.cos(latitude) - math.cos(declination) * math.cos(angle) * math.sin(latitude),
            math.sin(declination) * math.sin(latitude) + math.cos(declination) * math.cos(angle) * math.cos(latitude))
