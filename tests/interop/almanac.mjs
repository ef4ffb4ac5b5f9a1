// Prints where sun, moon and four stars are for twenty places and times, by astronomy-engine: rows of
// tests/compiler/sky/almanac.inc. Directions are apparent: east, north, up.
import {Body, DefineStar, Equator, Horizon, Illumination, Observer} from "astronomy-engine";

const MOMENTS = [
  [1.52, 42.51, "2026-06-21T15:00:00Z"], [7.42, 43.74, "2026-12-21T11:30:00Z"], [-87.63, 41.88, "2026-07-04T02:15:00Z"],
  [12.3, 48.7, "2026-03-20T05:40:00Z"], [0, 51.48, "2000-01-01T12:00:00Z"], [25.73, 66.5, "2026-06-21T22:10:00Z"],
  [15.64, 78.22, "2026-06-10T23:30:00Z"], [15.64, 78.22, "2026-12-30T11:00:00Z"], [166.67, -77.85, "2027-01-05T13:00:00Z"],
  [0, -89.9, "2026-09-23T06:00:00Z"], [0, 89.9, "2026-03-21T18:00:00Z"], [-58.38, -34.6, "2026-02-01T23:10:00Z"],
  [151.21, -33.87, "2026-08-28T18:45:00Z"], [139.69, 35.68, "2019-04-30T15:00:00Z"], [-157.86, 21.31, "2035-05-26T10:00:00Z"],
  [36.82, -1.29, "2026-03-20T09:37:00Z"], [-78.47, -0.18, "1969-07-20T20:17:40Z"], [179.9, -17.7, "2026-10-26T05:30:00Z"],
  [-21.94, 64.15, "2026-01-03T23:59:59Z"], [77.2, 28.6, "2049-11-09T00:45:00Z"]];

// Right ascension (hours) and declination of J2000.0: Sirius, Vega, Polaris, Acrux
const STARS = [[6.752481, -16.7161, 8.6], [18.615649, 38.7837, 25], [2.530302, 89.2641, 430], [12.443308, -63.0991, 320]];
const BODIES = [Body.Star1, Body.Star2, Body.Star3, Body.Star4];
STARS.forEach(([hours, degrees, lightYears], i) => DefineStar(BODIES[i], hours, degrees, lightYears));

const radians = Math.PI / 180;
function direction(body, time, observer) {
  const {ra, dec} = Equator(body, time, observer, true, true);
  const {altitude, azimuth} = Horizon(time, observer, ra, dec, "normal");
  const level = Math.cos(altitude * radians);
  const v = [level * Math.sin(azimuth * radians), level * Math.cos(azimuth * radians), Math.sin(altitude * radians)];
  return `{${v.map(c => c.toFixed(6)).join(", ")}}`;
}

for (const [lon, lat, text] of MOMENTS) {
  const time = new Date(text), observer = new Observer(lat, lon, 0);
  const bodies = [Body.Sun, Body.Moon, ...BODIES].map(body => direction(body, time, observer));
  const lit = Illumination(Body.Moon, time).phase_fraction.toFixed(4);
  console.log(`{{${lon}, ${lat}}, "${text}", ${lit}, ${bodies.join(", ")}},`);
}
