#include "compiler/map/plane/plane.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "compiler/map/plane/precise_plane.h"

namespace citykiln::map {
namespace {

using GeographicLib::Geodesic;

const LonLat kPlaneOrigins[] = {{7.42, 43.73}, {-87.62, 41.88},  {174.87, -41.26}, {24.94, 60.17},
                                {0, 0},        {-43.05, -22.91}, {179.99, 10}};

double geodesic_m(LonLat a, LonLat b) {
  double metres = 0;
  Geodesic::WGS84().Inverse(a.lat_deg, a.lon_deg, b.lat_deg, b.lon_deg, metres);
  return metres;
}

TEST(Plane, OriginIsZero) {
  for (const LonLat origin : kPlaneOrigins) {
    const Vec2 p = Plane(origin).forward(origin);
    EXPECT_NEAR(p.x, 0, 1e-8);
    EXPECT_NEAR(p.y, 0, 1e-8);
  }
}

TEST(Plane, XIsEastAndYIsNorth) {
  for (const LonLat origin : kPlaneOrigins) {
    const Plane plane(origin);
    EXPECT_GT(plane.forward({origin.lon_deg + 0.005, origin.lat_deg}).x, 0);
    EXPECT_GT(plane.forward({origin.lon_deg, origin.lat_deg + 0.005}).y, 0);
  }
}

TEST(Plane, LengthsAreWithin8PpmOfTheGeodesicWithin25Km) {
  for (const LonLat origin : kPlaneOrigins) {
    const Plane plane(origin);
    for (const double x : {-25000.0, -9000.0, 0.0, 14000.0, 25000.0}) {
      for (const double y : {-25000.0, 0.0, 25000.0}) {
        for (const Vec2 step : {Vec2{100, 0}, Vec2{0, 100}, Vec2{70, -70}}) {
          const Vec2 p{x, y};
          const double metres = geodesic_m(plane.backward(p), plane.backward(p + step));
          EXPECT_LT(std::abs(length(step) / metres - 1), 8e-6) << origin.lon_deg << " " << x << " " << y;
        }
      }
    }
  }
}

TEST(Plane, BackwardUndoesForwardTo10Nanometres) {
  for (const LonLat origin : kPlaneOrigins) {
    const Plane plane(origin);
    for (double x = -60000; x <= 60000; x += 7919) {
      const Vec2 p{x, 1000 - 0.7 * x}, again = plane.forward(plane.backward(p));
      EXPECT_LT(distance(p, again), 1e-8);
    }
  }
}

TEST(Plane, PreciseBackwardUndoesPreciseForward) {
  for (const LonLat origin : kPlaneOrigins) {
    for (double x = -60000; x <= 60000; x += 9973) {
      const Vec2 p{x, 500 + 0.4 * x};
      const PrecisePoint again = precise_forward(origin, precise_backward(origin, p, Plane(origin).backward(p)));
      EXPECT_LT(std::abs(static_cast<double>(again.x - p.x)), 1e-11);
      EXPECT_LT(std::abs(static_cast<double>(again.y - p.y)), 1e-11);
    }
  }
}

Vec2 precisely_snapped(LonLat origin, source::Location place) {
  const PrecisePoint p = precise_forward(origin, {place.lon_deg(), place.lat_deg()});
  const auto snap = [](long double v) { return static_cast<double>(floorl(v / kMapStep_m + 0.5L)) * kMapStep_m; };
  return {snap(p.x), snap(p.y)};
}

// Deterministic places of OSM's grid.
source::Location nth_place(LonLat origin, std::int64_t n) {
  return {static_cast<std::int32_t>(std::lround(origin.lon_deg * 1e7) + n * 7919 % 2000003 - 1000001),
          static_cast<std::int32_t>(std::lround(origin.lat_deg * 1e7) + n * 104729 % 2000029 - 1000014)};
}

TEST(Plane, SnappedForwardIsTheNearestPointOfTheGrid) {
  const LonLat origin{7.42, 43.73};
  const Plane plane(origin);
  for (std::int64_t n = 0; n < 20000; ++n) {
    const source::Location place = nth_place(origin, n);
    ASSERT_EQ(plane.snapped_forward(place), precisely_snapped(origin, place)) << n;
  }
}

// Places near Wellington where the double is on the other side of a tie than the exact value: four of 12 million tried.
TEST(Plane, NearTiesAreDecidedInHigherPrecision) {
  const LonLat origin{174.87, -41.26};
  const Plane plane(origin);
  for (const source::Location place :
       {source::Location{1748601537, -412892407}, source::Location{1749481349, -413027981},
        source::Location{1749550059, -412556111}, source::Location{1748415872, -412499962}})
    EXPECT_EQ(plane.snapped_forward(place), precisely_snapped(origin, place)) << place.lon_e7;
}

// The bound on which the width of the window about ties is based.
TEST(Plane, TheDoubleIsWithin8NanometresOfTheTruth) {
  for (const LonLat origin : kPlaneOrigins) {
    const Plane plane(origin);
    for (std::int64_t n = 0; n < 20000; ++n) {
      const source::Location place = nth_place(origin, n);
      const Vec2 p = plane.forward({place.lon_deg(), place.lat_deg()});
      const PrecisePoint truth = precise_forward(origin, {place.lon_deg(), place.lat_deg()});
      ASSERT_LT(std::abs(static_cast<double>(truth.x - p.x)), 8e-9);
      ASSERT_LT(std::abs(static_cast<double>(truth.y - p.y)), 8e-9);
    }
  }
}

TEST(Plane, PlacesFarAwayAreFinite) {
  const Plane plane({7.42, 43.73});
  for (const source::Location place :
       {source::Location{0, 0}, source::Location{974200000, 0}, source::Location{-825800000, 0},
        source::Location{0, 900000000}, source::Location{0, -900000000}, source::Location{1800000000, 0},
        source::Location{-1725800000, -437300000}}) {
    const Vec2 p = plane.snapped_forward(place);
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y))
        << place.lon_deg() << " " << place.lat_deg() << ": " << p.x << " " << p.y;
  }
}

}  // namespace
}  // namespace citykiln::map
